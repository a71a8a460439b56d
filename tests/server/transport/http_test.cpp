// HTTP over a real socket: what is served and what is refused, after which the server still works.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "tests/server/transport/staged_server.h"

namespace selvage::test {
namespace {

using namespace std::chrono_literals;

server::transport::access::TransportLimits small_requests() {
  server::transport::access::TransportLimits limits;
  limits.body_bytes = 1000;
  limits.header_bytes = 2048;
  return limits;
}

class Http : public ::testing::Test {
 protected:
  // Sends bytes on a new connection and expects one answer with this status.  Afterwards the server must still work.
  void expect_refused(std::string_view bytes, int status) {
    Wire wire{server_.port()};
    (void)wire.try_send(bytes);  // the server may refuse and close before it has read everything
    const auto answer = wire.answer();
    ASSERT_TRUE(answer) << bytes.substr(0, 200);
    EXPECT_EQ(answer->status, status) << bytes.substr(0, 200) << "\n" << answer->body;
    EXPECT_TRUE(answer->says("Connection: close"));
    wire.half_close();
    EXPECT_EQ(wire.rest(), "") << "a second answer to " << bytes.substr(0, 200);
    expect_well();
  }
  void expect_well() {
    const auto answer = Wire{server_.port()}.post("{}");
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 200);
  }

  StagedServer server_{small_requests()};
};

TEST_F(Http, AnswersManyRequestsOnOneConnection) {
  Wire wire{server_.port()};
  for (const auto* body : {"{\"n\":1}", "[2]", "anything"}) {
    const auto answer = wire.post(body);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 200);
    EXPECT_EQ(answer->body, body);
    EXPECT_TRUE(answer->says("Content-Type: application/json\r\n"));
    EXPECT_FALSE(answer->says("Connection: close"));
  }
}

TEST_F(Http, AcceptsPipelinedAndFragmentedRequests) {
  Wire wire{server_.port()};
  const std::string two = post_request("first") + post_request("second");
  for (const char byte : two) wire.send({&byte, 1});
  EXPECT_EQ(wire.answer().value_or(HttpAnswer{}).body, "first");
  EXPECT_EQ(wire.answer().value_or(HttpAnswer{}).body, "second");
}

TEST_F(Http, ANotificationIsAnsweredWithNoContent) {
  const auto answer = Wire{server_.port()}.post("silent");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 204);
  EXPECT_EQ(answer->body, "");
}

TEST_F(Http, HealthIsAnsweredWhileACallIsHeld) {
  Wire busy{server_.port()};
  busy.send(post_request("hold"));
  const HeldCall held = server_.next_held();
  Wire wire{server_.port()};
  wire.send("GET /healthz HTTP/1.1\r\nHost: 127.0.0.1:7171\r\n\r\n");
  const auto answer = wire.answer();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  EXPECT_EQ(answer->body, "well");
  held.reply("done");
  EXPECT_EQ(busy.answer().value_or(HttpAnswer{}).body, "done");
}

TEST_F(Http, PagesReportTheState) {
  Wire wire{server_.port()};
  const auto get = [&wire](const std::string& target) {
    wire.send("GET " + target + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
    return wire.answer().value_or(HttpAnswer{});
  };
  EXPECT_EQ(get("/readyz").status, 200);
  server_.set_why_not_ready("full");
  const HttpAnswer full = get("/readyz");
  EXPECT_EQ(full.status, 503);
  EXPECT_EQ(full.body, "full\n");
  EXPECT_FALSE(full.says("Connection: close"));
  const HttpAnswer metrics = get("/metrics");
  EXPECT_EQ(metrics.status, 200);
  EXPECT_EQ(metrics.body, "up 1\n");
  EXPECT_TRUE(metrics.says("Content-Type: text/plain; version=0.0.4\r\n"));
  EXPECT_EQ(get("/openrpc.json").status, 404);  // this service has no such page
}

TEST_F(Http, ConnectionsAreCountedWhileTheyAreOpen) {
  {
    Wire wire{server_.port()};
    ASSERT_TRUE(wire.post("{}"));
    EXPECT_EQ(server_.counts().http, 1U);
    wire.send(post_request("x", "Connection: close\r\n"));
    ASSERT_TRUE(wire.answer());
    EXPECT_EQ(wire.rest(), "");
  }
  EXPECT_EQ(server_.counts().http, 0U);
  EXPECT_EQ(server_.counts().accepted, 1U);
}

TEST_F(Http, ClosesOnRequest) {
  Wire wire{server_.port()};
  wire.send(post_request("x", "Connection: close\r\n"));
  const auto answer = wire.answer();
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->says("Connection: close"));
  EXPECT_EQ(wire.rest(), "");
}

TEST_F(Http, SendsContinueToAClientThatWaitsForIt) {
  Wire wire{server_.port()};
  wire.send("POST /rpc HTTP/1.1\r\nHost: localhost\r\nExpect: 100-continue\r\nContent-Length: 2\r\n\r\n");
  EXPECT_EQ(wire.answer().value_or(HttpAnswer{}).status, 100);
  wire.send("{}");
  EXPECT_EQ(wire.answer().value_or(HttpAnswer{}).body, "{}");
}

TEST_F(Http, RefusesTransferEncodings) {
  const std::string start = "POST /rpc HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: ";
  expect_refused(start + "chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n", 411);
  expect_refused(start + "chunked\r\n\r\n0\r\nX: " + std::string(1 << 20, 'x') + "\r\n\r\n", 411);
  expect_refused(start + "chunked\r\n\r\n2;" + std::string(1 << 20, 'x') + "\r\n{}\r\n0\r\n\r\n", 411);
  // The body must not be interpreted as a second request.
  expect_refused(start + "gzip\r\n\r\n" + post_request("smuggled"), 411);
  expect_refused(start + "identity\r\nContent-Length: 2\r\n\r\n{}", 411);
}

TEST_F(Http, RefusesWrongContentLengths) {
  const std::string start = "POST /rpc HTTP/1.1\r\nHost: localhost\r\n";
  expect_refused(start + "\r\n", 411);
  expect_refused(start + "Content-Length: two\r\n\r\n{}", 400);
  expect_refused(start + "Content-Length: -2\r\n\r\n{}", 400);
  expect_refused(start + "Content-Length: 99999999999999999999999\r\n\r\n{}", 400);
  expect_refused(start + "Content-Length: 2\r\nContent-Length: 3\r\n\r\n{} ", 400);
  expect_refused(start + "Content-Length: 2\r\nTransfer-Encoding: chunked\r\n\r\n{}", 400);
}

TEST_F(Http, AnIncompleteBodyIsNotACall) {
  Wire wire{server_.port()};
  wire.send("POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Length: 10\r\n\r\nhold");
  wire.half_close();
  EXPECT_EQ(wire.rest(), "");
  EXPECT_EQ(server_.held(), 0U);
  expect_well();
}

TEST_F(Http, RefusesBodiesAndHeadersBeyondTheLimits) {
  expect_refused(post_request(std::string(1001, 'x')), 413);
  expect_refused("POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Length: 99999999999\r\n\r\n", 413);
  expect_refused(post_request("{}", "X: " + std::string(3000, 'x') + "\r\n"), 431);
  expect_refused("POST /" + std::string(1 << 20, 'x') + " HTTP/1.1\r\n\r\n", 431);
  Wire wire{server_.port()};
  EXPECT_EQ(wire.post(std::string(1000, 'x')).value_or(HttpAnswer{}).status,
            200);  // the limit itself is allowed
}

TEST_F(Http, RefusesForeignHostsAndOrigins) {
  const std::string rest = "\r\nContent-Length: 2\r\n\r\n{}";
  expect_refused("POST /rpc HTTP/1.1\r\nHost: example.com" + rest, 403);
  expect_refused("POST /rpc HTTP/1.1\r\nHost: localhost.example.com:7171" + rest, 403);
  expect_refused("POST /rpc HTTP/1.1\r\nHost: localhost\r\nHost: example.com" + rest, 403);
  expect_refused("POST /rpc HTTP/1.1\r\nHost:" + rest, 403);
  expect_refused("POST /rpc HTTP/1.1\r\nX: y" + rest, 403);
  expect_refused("GET /healthz HTTP/1.1\r\nHost: example.com\r\n\r\n", 403);
  expect_refused(post_request("{}", "Origin: http://example.com\r\n"), 403);
  expect_refused(post_request("{}", "Origin: null\r\n"), 403);
  expect_refused(post_request("{}", "Origin: http://localhost\r\nOrigin: http://example.com\r\n"), 403);
  Wire wire{server_.port()};
  wire.send(post_request("{}", "Origin: http://localhost:3000\r\n"));
  EXPECT_EQ(wire.answer().value_or(HttpAnswer{}).status, 200);
}

TEST_F(Http, RefusesOtherMethodsAndPaths) {
  const std::string host = " HTTP/1.1\r\nHost: localhost\r\n\r\n";
  for (const auto* method : {"GET", "PUT", "DELETE", "PATCH", "BREW"}) {
    expect_refused(std::string{method} + " /rpc" + host, 405);
  }
  for (const auto* path : {"/readyz", "/metrics", "/ws"}) {
    expect_refused(std::string{"PUT "} + path + " HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n", 405);
  }
  expect_refused("POST /healthz HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n", 405);
  for (const auto* path : {"/", "/rpc/", "/rpc?x=1", "/RPC", "/../rpc", "http://localhost/rpc"}) {
    expect_refused(std::string{"POST "} + path + " HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n", 404);
  }
}

TEST_F(Http, RefusesWhatIsNotHttp) {
  expect_refused("hello there\r\n\r\n", 400);
  expect_refused("\x16\x03\x01\x02\x01\x01 \r\n\r\n", 400);  // the first bytes of a TLS connection
  expect_refused("POST /rpc HTTP/9.9\r\nHost: localhost\r\n\r\n", 400);
  expect_refused("POST /rpc HTTP/1.1\r\nHost : localhost\r\n\r\n", 400);
  expect_refused("POST /rpc HTTP/1.1\r\n folded: x\r\n\r\n", 400);
}

TEST_F(Http, ADisconnectedClientStopsItsCall) {
  for (const bool broken : {false, true}) {
    Wire wire{server_.port()};
    wire.send(post_request("hold"));
    const HeldCall held = server_.next_held();
    EXPECT_FALSE(held.caller.stop_requested());
    broken ? wire.reset() : wire.close();
    EXPECT_TRUE(stops(held.caller));
    held.reply("nobody reads this");
  }
  expect_well();
}

TEST_F(Http, AnExceptionOfTheServiceEndsOnlyItsConnection) {
  Wire wire{server_.port()};
  wire.send(post_request("throw"));
  EXPECT_EQ(wire.rest(), "");
  expect_well();
}

TEST(HttpTimes, ASlowClientIsDisconnected) {
  server::transport::access::TransportLimits limits;
  limits.request = 50ms;
  StagedServer server{limits};
  for (const auto* start :
       {"POST /rpc HTTP/1.1\r\nHost: lo", "POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Length: 9\r\n\r\nhold"}) {
    Wire wire{server.port()};
    wire.send(start);
    EXPECT_EQ(wire.rest(), "");
  }
  EXPECT_EQ(server.held(), 0U);
}

TEST(HttpTimes, ASilentClientIsDisconnectedUnlessItsCallIsInProgress) {
  server::transport::access::TransportLimits limits;
  limits.idle = 50ms;
  limits.request = 50ms;
  StagedServer server{limits};
  Wire busy{server.port()};
  busy.send(post_request("hold"));
  const HeldCall held = server.next_held();
  EXPECT_EQ(Wire{server.port()}.rest(), "");  // it has waited longer than both limits
  held.reply("done");
  EXPECT_EQ(busy.answer().value_or(HttpAnswer{}).body, "done");
  EXPECT_EQ(busy.rest(), "");
}

TEST(HttpTimes, AClientThatDoesNotReadItsAnswerIsDisconnected) {
  server::transport::access::TransportLimits limits;
  limits.write = 50ms;
  limits.body_bytes = 64 << 20;
  StagedServer server{limits};
  Wire wire{server.port()};
  wire.send(post_request("hold"));
  const HeldCall held = server.next_held();
  held.reply(std::string(64 << 20, 'x'));  // more than the buffers of the sockets hold
  EXPECT_TRUE(stops(held.caller));
}

TEST(HttpTimes, ManySlowClientsDoNotDelayOthers) {
  server::transport::access::TransportLimits limits;
  limits.request = 2s;
  limits.write = 2s;
  StagedServer server{limits};
  std::vector<std::unique_ptr<Wire>> slow;
  for (int i = 0; i < 200; ++i) {
    slow.push_back(std::make_unique<Wire>(server.port()));
    slow.back()->send(i % 2 == 0 ? "POST /rpc HTTP/1.1\r\nX-Slow: a" : "{\"begun\":");
  }
  std::vector<HeldCall> unread;
  for (int i = 0; i < 8; ++i) {
    slow.push_back(std::make_unique<Wire>(server.port()));
    slow.back()->send(post_request("hold"));
    unread.push_back(server.next_held());
    unread.back().reply(std::string(16 << 20, 'x'));
  }
  Wire quick{server.port()};
  for (int i = 0; i < 100; ++i) EXPECT_EQ(quick.post("{}").value_or(HttpAnswer{}).status, 200);
  for (const HeldCall& held : unread) EXPECT_TRUE(stops(held.caller));
  for (int i = 0; i < 200; ++i) EXPECT_EQ(slow[static_cast<std::size_t>(i)]->rest(), "");
}

TEST(HttpConnections, ThoseBeyondTheLimitAreRefused) {
  server::transport::access::TransportLimits limits;
  limits.connections = 2;
  StagedServer server{limits};
  Wire first{server.port()};
  Wire second{server.port()};
  for (Wire* wire : {&first, &second}) wire->send(post_request("hold"));
  const HeldCall one = server.next_held();
  const HeldCall two = server.next_held();
  EXPECT_EQ(Wire{server.port()}.rest(), "");
  one.reply("1");
  two.reply("2");
  EXPECT_TRUE(first.answer() && second.answer());
  EXPECT_TRUE(first.post("3"));
}

TEST(HttpDrain, ClosesIdleConnectionsAndAnswersCallsInProgress) {
  StagedServer server;
  Wire idle{server.port()};
  ASSERT_TRUE(idle.post("{}"));
  Wire busy{server.port()};
  busy.send(post_request("hold"));
  const HeldCall held = server.next_held();
  server.transport().stop_reading();
  EXPECT_EQ(idle.rest(), "");
  EXPECT_THROW(Wire{server.port()}, std::system_error);
  EXPECT_FALSE(held.caller.stop_requested());  // the caller is still connected
  held.reply("done");
  server.transport().finish(kPatience);
  const auto answer = busy.answer();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->body, "done");
  EXPECT_TRUE(answer->says("Connection: close"));
}

}  // namespace
}  // namespace selvage::test
