// HEAD, OPTIONS, and what lets pages of allowed origins call from a browser (CORS).
#include <gtest/gtest.h>

#include <string>

#include "tests/server/transport/staged_server.h"

namespace selvage::test {
namespace {

using server::transport::access::Listener;
using server::transport::access::ListenSettings;

constexpr std::string_view kFront = "https://front.example";

std::string request(const std::string& line, const std::string& more_fields = "") {
  return line + " HTTP/1.1\r\nHost: localhost\r\n" + more_fields + "\r\n";
}

class HttpPages : public ::testing::Test {
 protected:
  static ListenSettings settings() {
    ListenSettings listen;
    listen.access.token = "correct horse battery";
    listen.access.origins = {std::string{kFront}};
    return listen;
  }
  HttpAnswer answer_to(const std::string& text) {
    Wire wire{server_.port()};
    wire.send(text);
    return wire.answer().value_or(HttpAnswer{});
  }
  StagedServer server_{settings()};
  const std::string token_{"Authorization: Bearer correct horse battery\r\n"};
  const std::string origin_{"Origin: " + std::string{kFront} + "\r\n"};
};

TEST_F(HttpPages, HeadIsAnsweredAsGetWithoutTheBody) {
  Wire wire{server_.port()};
  for (const std::string page : {"/healthz", "/readyz", "/metrics"}) {
    wire.send(request("GET " + page, token_));
    const HttpAnswer whole = wire.answer().value_or(HttpAnswer{});
    wire.send(request("HEAD " + page, token_));
    const HttpAnswer head = wire.answer_without_body().value_or(HttpAnswer{});
    EXPECT_EQ(head.status, 200) << page;
    EXPECT_EQ(head.header, whole.header);  // its Content-Length, too
    EXPECT_FALSE(whole.body.empty());
  }
  wire.send(request("HEAD /healthz", "Connection: close\r\n"));
  EXPECT_TRUE(wire.answer_without_body());
  EXPECT_EQ(wire.rest(), "");
}

TEST_F(HttpPages, ARefusalOfHeadHasNoBodyEither) {
  for (const std::string line : {"HEAD /rpc", "HEAD /ws", "HEAD /nothing"}) {
    Wire wire{server_.port()};
    wire.send(request(line, token_));
    const HttpAnswer refused = wire.answer_without_body().value_or(HttpAnswer{});
    EXPECT_EQ(refused.status, line == "HEAD /nothing" ? 404 : 405) << line;
    wire.half_close();
    EXPECT_EQ(wire.rest(), "");
  }
}

TEST_F(HttpPages, APreflightOfAnAllowedOriginIsAnsweredWithoutToken) {
  const std::string preflight =
      "Access-Control-Request-Method: POST\r\nAccess-Control-Request-Headers: authorization,content-type\r\n";
  Wire wire{server_.port()};
  wire.send(request("OPTIONS /rpc", origin_ + preflight));
  const HttpAnswer answer = wire.answer().value_or(HttpAnswer{});
  EXPECT_EQ(answer.status, 204);
  EXPECT_TRUE(answer.says("Access-Control-Allow-Origin: https://front.example\r\n")) << answer.header;
  EXPECT_TRUE(answer.says("Access-Control-Allow-Methods: POST, OPTIONS\r\n"));
  EXPECT_TRUE(answer.says("Access-Control-Allow-Headers: Authorization, Content-Type\r\n"));
  EXPECT_TRUE(answer.says("Vary: Origin\r\n"));
  EXPECT_FALSE(answer.says("Private-Network"));
  // The connection is still usable, for the request that follows.
  wire.send(post_request("{}", token_ + origin_));
  const HttpAnswer called = wire.answer().value_or(HttpAnswer{});
  EXPECT_EQ(called.status, 200);
  EXPECT_TRUE(called.says("Access-Control-Allow-Origin: https://front.example\r\n"));
  EXPECT_TRUE(called.says("Vary: Origin\r\n"));
  EXPECT_TRUE(
      answer_to(request("OPTIONS /rpc", origin_ + preflight + "Access-Control-Request-Private-Network: true\r\n"))
          .says("Access-Control-Allow-Private-Network: true\r\n"));
}

TEST_F(HttpPages, APageMayReadARefusalToo) {
  const HttpAnswer refused = answer_to(post_request("{}", origin_));
  EXPECT_EQ(refused.status, 401);
  EXPECT_TRUE(refused.says("Access-Control-Allow-Origin: https://front.example\r\n"));
}

TEST_F(HttpPages, OtherOriginsMayReadNothing) {
  for (const std::string method : {"OPTIONS /rpc", "GET /metrics"}) {
    const HttpAnswer answer = answer_to(
        request(method, token_ + "Origin: https://foreign.example\r\nAccess-Control-Request-Method: POST\r\n"));
    EXPECT_EQ(answer.status, 403);
    EXPECT_FALSE(answer.says("Access-Control"));
  }
  EXPECT_FALSE(answer_to(post_request("{}", token_)).says("Access-Control"));
}

TEST_F(HttpPages, OptionsListsTheAllowedMethods) {
  const auto allow = [&](const std::string& target) {
    const HttpAnswer answer = answer_to(request("OPTIONS " + target));
    EXPECT_EQ(answer.status, 204) << target;
    const std::size_t field = answer.header.find("Allow: ");
    return field == std::string::npos ? "" : answer.header.substr(field, answer.header.find("\r\n", field) - field);
  };
  EXPECT_EQ(allow("/rpc"), "Allow: POST, OPTIONS");
  EXPECT_EQ(allow("/ws"), "Allow: GET, OPTIONS");
  EXPECT_EQ(allow("/metrics"), "Allow: GET, HEAD, OPTIONS");
  EXPECT_EQ(answer_to(request("OPTIONS /nothing", token_)).status, 404);
  EXPECT_EQ(answer_to("OPTIONS /rpc HTTP/1.1\r\nHost: localhost\r\nHost: other\r\n\r\n").status, 403);
}

}  // namespace
}  // namespace selvage::test
