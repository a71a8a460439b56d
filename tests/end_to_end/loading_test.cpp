// A daemon whose store is still being loaded: its ports are open, and it says that it is loading.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "server/app/daemon.h"
#include "server/store/disk/database.h"
#include "tests/end_to_end/calls.h"
#include "tests/end_to_end/process.h"
#include "tests/server/store/temporary_folder.h"
#include "tests/server/wire/websocket_wire.h"

namespace selvage::test {
namespace {

using server::store::disk::Database;

class Loading : public ::testing::Test {
 protected:
  Loading() {
    options_.store = folder_.file("store");
    server::app::Daemon daemon{options_};
    daemon.wait_until_loaded();
    Wire wire{daemon.port()};
    EXPECT_EQ(open_marker(wire, kSmallMarker), "m1");
  }
  static std::string page(std::uint16_t port, const std::string& path) {
    Wire wire{port};
    wire.send("GET " + path + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
    const HttpAnswer answer = wire.answer().value_or(HttpAnswer{});
    return std::to_string(answer.status) + " " + answer.body;
  }
  static void expect_retryable(const Json& answer) {
    EXPECT_EQ(answer["error"]["code"], -32010) << answer;
    EXPECT_GT(answer["error"]["data"]["retryAfterMs"].number(), 0) << answer;
  }

  TemporaryFolder folder_;
  server::app::Options options_ = on_free_port(1);
};

TEST_F(Loading, ThePortsAreOpenAndCallsAreRefusedUntilItIsDone) {
  Database other{options_.store, Database::Access::kExisting};
  other.run("BEGIN IMMEDIATE");  // the daemon's first transaction waits for it
  server::app::Daemon daemon{options_};
  EXPECT_EQ(page(daemon.port(), "/healthz").substr(0, 3), "200");
  EXPECT_EQ(page(daemon.port(), "/readyz"), "503 loading the markers of the store\n");
  EXPECT_EQ(page(daemon.port(), "/").substr(0, 3), "200");
  EXPECT_NE(page(daemon.port(), "/metrics").find("selvage_build_info"), std::string::npos);

  Wire http{daemon.port()};
  const std::string get = id_params("m1");
  const HttpAnswer refused = http.post(call(7, "marker.get", get)).value_or(HttpAnswer{});
  EXPECT_EQ(refused.status, 503);
  EXPECT_TRUE(refused.says("Retry-After: 1\r\n"));
  expect_retryable(Json::parse(refused.body));
  EXPECT_EQ(Json::parse(refused.body)["id"], 7);

  Wire lines{daemon.port()};
  lines.send("[" + call(8, "marker.get", get) + "," + call(9, "marker.list") + "]\n");
  const Json batch = Json::parse(lines.line().value_or("[]"));
  ASSERT_EQ(batch.size(), 2U);
  for (const Json& answer : batch) expect_retryable(answer);
  lines.send(R"({"jsonrpc":"2.0","id":123456789012345678901234567890,"method":"marker.list"})"
             "\n");
  EXPECT_NE(lines.line().value_or("").find("\"id\":123456789012345678901234567890,"), std::string::npos);
  WebSocketWire socket{daemon.port()};
  socket.send_text(call(3, "marker.list"));
  expect_retryable(Json::parse(socket.text().value_or("{}")));

  other.run("ROLLBACK");
  daemon.wait_until_loaded();
  EXPECT_EQ(page(daemon.port(), "/readyz"), "200 ready\n");
  EXPECT_EQ(http.post(call(1, "marker.get", get)).value_or(HttpAnswer{}).status, 200);
  lines.send(call(2, "marker.get", get) + "\n");
  EXPECT_EQ(Json::parse(lines.line().value_or("{}"))["result"]["revision"], 1);
  socket.send_text(call(4, "marker.list"));
  EXPECT_EQ(Json::parse(socket.text().value_or("{}"))["result"]["markers"].size(), 1U);
}

TEST_F(Loading, EndsWhenTheDaemonIsShutDown) {
  Database other{options_.store, Database::Access::kExisting};
  other.run("BEGIN IMMEDIATE");
  server::app::Daemon daemon{options_};
  daemon.drain();
  EXPECT_FALSE(daemon.wait_until_loaded());
  other.run("ROLLBACK");
}

// The daemon would wait for five seconds and end with code 1, because it cannot use the store.
TEST_F(Loading, EndsOnASignal) {
  Database other{options_.store, Database::Access::kExisting};
  other.run("BEGIN IMMEDIATE");
  for (const int signal : {SIGTERM, SIGINT}) {
    const std::string socket = folder_.file("socket"), ports = folder_.file("ports");
    Process selvaged{{SELVAGED, "--listen", "127.0.0.1:0", "--listen-unix", socket, "--port-file", ports, "--store",
                      options_.store}};
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!std::filesystem::exists(socket) && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    selvaged.signal(signal);
    EXPECT_EQ(selvaged.exit_code(), 0) << selvaged.all_output();
    EXPECT_FALSE(std::filesystem::exists(ports));
  }
}

// The store does not change, whatever is being read when the daemon is shut down.
TEST_F(Loading, ThatWasEndedLosesNothing) {
  for (const int microseconds : {0, 300, 1000, 3000, 10'000}) {
    server::app::Daemon daemon{options_};
    std::this_thread::sleep_for(std::chrono::microseconds{microseconds});
    daemon.drain();
  }
  server::app::Daemon daemon{options_};
  EXPECT_TRUE(daemon.wait_until_loaded());
  Wire wire{daemon.port()};
  EXPECT_EQ(result_of(post_call(wire, "marker.get", id_params("m1")))["revision"], 1);
}

TEST_F(Loading, AStoreThatCannotBeUsedIsReported) {
  Database{options_.store, Database::Access::kExisting}.run("DROP TABLE head");
  server::app::Daemon daemon{options_};
  EXPECT_THROW(daemon.wait_until_loaded(), std::runtime_error);
}

}  // namespace
}  // namespace selvage::test
