// A client that reads slowly but steadily gets its whole answer, however long that takes.
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "tests/server/transport/staged_server.h"
#include "tests/server/wire/websocket_wire.h"

namespace selvage::test {
namespace {

using namespace std::chrono_literals;

TEST(SlowReaders, OnlyTimeWithoutProgressIsLimited) {
  constexpr std::size_t kAnswer = std::size_t{32} << 20;  // more than the buffers of the sockets hold
  constexpr int kParts = 50;
  constexpr auto kPause = 80ms;  // 4 s in all, twice the time limit
  server::transport::access::TransportLimits limits;
  limits.write = 2s;
  StagedServer server{limits};
  Wire http{server.port()};
  Wire lines{server.port()};
  WebSocketWire socket{server.port()};
  http.send(post_request("hold"));
  lines.send("{\"hold\":1}\n");
  socket.send_text("hold");
  for (int k = 0; k < 3; ++k) server.next_held().reply(std::string(kAnswer, 'x'));
  for (int part = 0; part < kParts; ++part) {
    for (Wire* wire : {&http, &lines, &socket.wire()}) {
      ASSERT_EQ(wire->bytes(kAnswer / kParts).size(), kAnswer / kParts) << "part " << part;
    }
    std::this_thread::sleep_for(kPause);
  }
  EXPECT_EQ(lines.line().value_or("").size(), kAnswer - kAnswer / kParts * kParts);
}

}  // namespace
}  // namespace selvage::test
