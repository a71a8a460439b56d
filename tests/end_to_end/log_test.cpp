// The log of the program: no call waits for it, and it records who called and who was refused.
#include <csignal>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/end_to_end/selvaged_test.h"

namespace selvage::test {
namespace {

class SelvagedLog : public SelvagedTest {
 protected:
  // The lines of the log that have this message.
  std::vector<Json> lines_of(const std::string& message) const {
    std::vector<Json> found;
    std::ifstream file{folder_.file("log")};
    for (std::string line; std::getline(file, line);) {
      Json parsed = Json::parse(line);
      if (parsed["message"] == message) found.push_back(std::move(parsed));
    }
    return found;
  }
};

TEST_F(SelvagedLog, NobodyWaitsForALogThatIsNotRead) {
  constexpr int kCalls = 100'000;
  constexpr int kTogether = 50;
  Process selvaged{arguments({})};  // its stderr is a pipe that is not read from now on
  const std::uint16_t port = port_of(selvaged);
  Wire lines{port};
  int answered = 0;
  for (int first = 0; first < kCalls; first += kTogether) {
    std::string calls;
    for (int k = 0; k < kTogether; ++k) calls += call(first + k, "marker.list") + "\n";
    lines.send(calls);
    for (int k = 0; k < kTogether && lines.line(); ++k) ++answered;
  }
  EXPECT_EQ(answered, kCalls);
  Wire page{port};
  page.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(page.answer().value_or(HttpAnswer{}).status, 200);
  page.send("GET /metrics HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const std::string metrics = page.answer().value_or(HttpAnswer{}).body;
  EXPECT_NE(metrics.find("\nselvage_log_lines_dropped_total "), std::string::npos);
  EXPECT_EQ(metrics.find("\nselvage_log_lines_dropped_total 0\n"), std::string::npos);
  selvaged.signal(SIGTERM);
  EXPECT_EQ(selvaged.exit_code(), 0);
}

TEST_F(SelvagedLog, AsJsonHasTheCallerOfEveryCall) {
  Process selvaged{arguments({"--log", folder_.file("log"), "--log-format", "json"})};
  Wire wire{port_of(selvaged)};
  const std::string id = open_marker(wire, kSmallMarker);
  wire.send(post_request(R"({"jsonrpc":"2.0","id":"seven","method":"marker.get","params":{"markerId":"m1"}})"));
  ASSERT_TRUE(wire.answer());
  ASSERT_FALSE(post_call(wire, "no.such\\nmethod").empty());
  selvaged.signal(SIGTERM);
  EXPECT_EQ(selvaged.exit_code(), 0);
  const std::vector<Json> calls = lines_of("call");
  ASSERT_EQ(calls.size(), 3U);
  EXPECT_EQ(calls[0]["marker"], id);
  const Json& line = calls[1];
  EXPECT_EQ(line["method"], "marker.get");
  EXPECT_EQ(line["marker"], id);
  EXPECT_EQ(line["level"], "info");
  EXPECT_EQ(line["code"], 0);
  EXPECT_EQ(line["request"], R"("seven")");
  EXPECT_EQ(line["session"], calls[0]["session"]);
  EXPECT_EQ(line["peer"].text().rfind("127.0.0.1:", 0), 0U) << line;
  EXPECT_GE(line["ms"].number(), 0.0);
  EXPECT_EQ(line["time"].text().size(), std::string{"2026-11-22T11:14:22.125Z"}.size());
  EXPECT_EQ(line["time"].text().back(), 'Z');
  EXPECT_EQ(calls[2]["method"], "no.such\nmethod");
  EXPECT_EQ(calls[2]["code"], -32601);
  EXPECT_EQ(lines_of("drained").size(), 1U);
}

TEST_F(SelvagedLog, RefusalsAreCountedAndLoggedAtALimitedRate) {
  constexpr int kStrangers = 300;
  const std::string token = folder_.write("token", "correct horse battery\n");
  Process selvaged{arguments({"--log", folder_.file("log"), "--log-format", "json", "--token-file", token})};
  const std::uint16_t port = port_of(selvaged);
  for (int k = 0; k < kStrangers; ++k) {
    Wire stranger{port};
    stranger.send(post_request("{}", "Authorization: Bearer wrong horse battery\r\n"));
    EXPECT_EQ(stranger.answer().value_or(HttpAnswer{}).status, 401);
  }
  Wire foreign{port};
  foreign.send(post_request("{}", "Origin: https://foreign.example\r\n"));
  EXPECT_EQ(foreign.answer().value_or(HttpAnswer{}).status, 403);
  Wire page{port};
  page.send("GET /metrics HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer correct horse battery\r\n\r\n");
  const std::string metrics = page.answer().value_or(HttpAnswer{}).body;
  EXPECT_NE(metrics.find("selvage_refused_total{reason=\"token\"} 300\n"), std::string::npos) << metrics;
  EXPECT_NE(metrics.find("selvage_refused_total{reason=\"foreign\"} 1\n"), std::string::npos) << metrics;
  selvaged.signal(SIGTERM);
  EXPECT_EQ(selvaged.exit_code(), 0);
  std::uint64_t tokens = 0;
  std::uint64_t others = 0;
  for (const Json& line : lines_of("refused")) {
    EXPECT_EQ(line["level"], "warning");
    EXPECT_EQ(line["peer"].text().rfind("127.0.0.1:", 0), 0U) << line;
    ++(line["reason"] == "token" ? tokens : others);
  }
  EXPECT_GE(tokens, 1U);
  EXPECT_LT(tokens, 300U);
  EXPECT_EQ(others, 1U);
}

}  // namespace
}  // namespace selvage::test
