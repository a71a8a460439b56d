// Fuzz target: the bytes of one HTTP connection, served by the whole transport except for the listening sockets.
//
// The first byte says whether the server requires a token.  Every answer must be HTTP; no call may reach the service
// without a Host header, from a foreign origin, or, if one is required, without the token.
#include "server/transport/connections/connection.h"  // before Asio

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/local/connect_pair.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/write.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include "tests/fuzz/entry.h"

namespace selvage::test {
namespace {

namespace asio = boost::asio;
namespace access = server::transport::access;
using server::transport::connections::Connection;
using server::transport::connections::ConnectionContext;
using server::transport::waiting::BulkTurns;
using Local = asio::local::stream_protocol;

constexpr std::string_view kToken = "correct horse battery";
constexpr std::size_t kMostBytes = 60'000;  // fits into the buffers of the socket pair

bool contains(std::string_view text, std::string_view part) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

// What the client of the connection has received, and the number of calls that reached the service.
struct Outcome {
  std::string received;
  std::size_t calls{};
};

Outcome serve(const std::string& bytes, bool needs_token) {
  Outcome outcome;
  asio::io_context io{1};
  Local::socket client{io};
  Local::socket inside{io};
  asio::local::connect_pair(client, inside);
  const access::Service service{
      .call =
          [&](std::string message, const auto&, const access::Reply& reply) {
            ++outcome.calls;
            reply(std::move(message));
          },
      .health = [] { return std::string{"well"}; },
      .ready = [] { return std::string{}; },
      .metrics = [] { return std::string{"up 1\n"}; },
  };
  const access::TransportLimits limits{.body_bytes = 10'000, .header_bytes = 4096};
  const access::Access rules{.token = std::string{needs_token ? kToken : ""}, .origins = {"https://front.example"}};
  BulkTurns turns{io};
  const ConnectionContext context{service, limits, rules, turns};
  const auto connection = std::make_shared<Connection>(std::move(inside), 1, "fuzz", needs_token);
  asio::write(client, asio::buffer(bytes));
  client.shutdown(Local::socket::shutdown_send);
  asio::co_spawn(io, serve_http(connection, context, {}), [connection](const std::exception_ptr& thrown) {
    demand(!thrown, "a connection threw an exception");
    connection->cut();
  });
  std::array<char, 65536> chunk{};
  std::function<void()> read = [&] {
    client.async_read_some(asio::buffer(chunk), [&](boost::system::error_code error, std::size_t count) {
      outcome.received.append(chunk.data(), count);
      if (!error) read();
    });
  };
  read();
  io.run_for(std::chrono::seconds{30});
  demand(io.stopped(), "the connection did not end");
  return outcome;
}

}  // namespace
}  // namespace selvage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace selvage::test;
  if (size < 2 || size > kMostBytes) return 0;
  const bool needs_token = bytes[0] % 2 == 1;
  const std::string text{bytes + 1, bytes + size};
  const Outcome outcome = serve(text, needs_token);
  demand(outcome.received.empty() || outcome.received.starts_with("HTTP/1.1 "), "an answer is not HTTP");
  if (outcome.calls == 0) return 0;
  demand(contains(text, "POST /rpc HTTP/1.") || contains(text, "GET /ws HTTP/1."), "a call without a request");
  demand(contains(text, "host:"), "a call without a Host");
  demand(!needs_token || text.find(kToken) != std::string::npos, "a call without the token");
  return 0;
}
