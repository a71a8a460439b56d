// Nothing that a page of a foreign site can make a browser send to a listener becomes a call.
//
// A browser adds the page's Origin to every POST and to every WebSocket upgrade, and the name that the page used as the
// Host.  A page cannot change them, but it controls the method, the body and most other headers.
#include <gtest/gtest.h>

#include <string>

#include "tests/server/store/temporary_folder.h"
#include "tests/server/transport/staged_server.h"
#include "tests/server/wire/websocket_wire.h"

namespace selvage::test {
namespace {

using server::transport::access::Listener;
using server::transport::access::ListenSettings;
using server::transport::access::Refusal;

constexpr std::string_view kForgedCall = R"({"jsonrpc":"2.0","id":1,"method":"hold","params":{"markerId":"m1"}})";

class Forgery : public ::testing::Test {
 protected:
  // What a form of a foreign page sends: text/plain, which needs no preflight.
  [[nodiscard]] static std::string form(std::string_view host, std::string_view origin) {
    const std::string body = "\n" + std::string{kForgedCall} + "\n";
    return "POST /rpc HTTP/1.1\r\nHost: " + std::string{host} + "\r\nOrigin: " + std::string{origin} +
           "\r\nContent-Type: text/plain\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  }
  [[nodiscard]] ListenSettings settings() const {
    ListenSettings listen;
    listen.listeners = {{.speaks = Listener::Speaks::kHttp, .host = "127.0.0.1"},
                        {.speaks = Listener::Speaks::kLines, .host = "127.0.0.1"},
                        {.speaks = Listener::Speaks::kLines, .path = folder_.file("s")}};
    return listen;
  }
  [[nodiscard]] std::uint16_t lines_port() { return server_.transport().listeners().at(1).port; }
  [[nodiscard]] std::uint64_t refused(Refusal refusal) const {
    return server_.counts().refused.at(static_cast<std::size_t>(refusal));
  }
  // The call that the service would hold has not arrived, and the server still works.
  void expect_no_call() {
    ASSERT_TRUE(Wire{server_.port()}.post("{}"));
    EXPECT_EQ(server_.held(), 0U);
  }

  const TemporaryFolder folder_;
  StagedServer server_{settings()};
};

TEST_F(Forgery, ALineListenerClosesOnHttp) {
  std::uint64_t attempts = 0;
  for (const std::string& request :
       {form("127.0.0.1:7172", "https://foreign.example"), form("foreign.example", "http://foreign.example"),
        "\r\n\n " + form("127.0.0.1:7172", "null"), "GET / HTTP/1.1\r\n\r\n" + std::string{kForgedCall} + "\n",
        std::string{"\x16\x03\x01\x02\x01\x01\n"} + std::string{kForgedCall} + "\n",
        "USER x\n" + std::string{kForgedCall} + "\n"}) {
    Wire wire{lines_port()};
    (void)wire.try_send(request);  // the server may close before it has read everything
    EXPECT_EQ(wire.rest(), "") << request;
    EXPECT_EQ(refused(Refusal::kNotJson), ++attempts);
  }
  Wire local{folder_.file("s")};
  (void)local.try_send(form("localhost", "https://foreign.example"));
  EXPECT_EQ(local.rest(), "");
  expect_no_call();
}

TEST_F(Forgery, AJsonLineIsServedOnALineListener) {
  for (const std::string first : {"", " \r\n\t\n"}) {
    Wire wire{lines_port()};
    wire.send(first + "{\"n\":1}\nnot JSON\n");
    EXPECT_EQ(wire.line(), "{\"n\":1}");
    EXPECT_EQ(wire.line(), "not JSON");  // a message like any other, which the service answers with an error
  }
  EXPECT_EQ(refused(Refusal::kNotJson), 0U);
}

TEST_F(Forgery, HttpRefusesForeignOriginsAndNames) {
  std::uint64_t attempts = 0;
  const auto expect_forbidden = [&](const std::string& request) {
    Wire wire{server_.port()};
    wire.send(request);
    EXPECT_EQ(wire.answer().value_or(HttpAnswer{}).status, 403) << request;
    EXPECT_EQ(refused(Refusal::kForeign), ++attempts);
  };
  expect_forbidden(form("127.0.0.1:7171", "https://foreign.example"));
  expect_forbidden(form("localhost", "null"));
  // DNS rebinding: the page's own name now leads here, so that Host and Origin agree.
  expect_forbidden(form("foreign.example", "http://foreign.example"));
  expect_forbidden("GET /metrics HTTP/1.1\r\nHost: foreign.example\r\n\r\n");
  expect_no_call();
}

TEST_F(Forgery, AWebSocketIsNotOpenedForForeignOriginsAndNames) {
  EXPECT_EQ((WebSocketWire{server_.port(), "Origin: https://foreign.example\r\n"}.status()), 403);
  EXPECT_EQ((WebSocketWire{server_.port(), "Origin: null\r\n"}.status()), 403);
  std::string rebound = upgrade_request("Origin: http://foreign.example\r\n");
  rebound.replace(rebound.find("Host: localhost"), 15, "Host: foreign.example");
  Wire wire{server_.port()};
  wire.send(rebound);
  EXPECT_EQ(wire.answer().value_or(HttpAnswer{}).status, 403);
  EXPECT_EQ(refused(Refusal::kForeign), 3U);
  expect_no_call();
}

// With a token nothing that a browser sends unasked is accepted, because it does not know the token.
TEST(ForgeryWithToken, EveryListenerRefusesIt) {
  ListenSettings listen;
  listen.listeners = {{.speaks = Listener::Speaks::kHttp, .host = "127.0.0.1"},
                      {.speaks = Listener::Speaks::kLines, .host = "127.0.0.1"}};
  listen.access.token = "correct horse battery";
  StagedServer server{listen};
  const std::string request = "POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100\r\n\r\n{\"hold\":1}\n";
  Wire http{server.port()};
  http.send(request);
  EXPECT_EQ(http.answer().value_or(HttpAnswer{}).status, 401);
  Wire lines{server.transport().listeners().at(1).port};
  (void)lines.try_send(request);
  EXPECT_EQ(lines.rest(), "stay out\n");
  EXPECT_EQ(server.counts().refused.at(static_cast<std::size_t>(Refusal::kToken)), 2U);
  EXPECT_EQ(server.held(), 0U);
}

}  // namespace
}  // namespace selvage::test
