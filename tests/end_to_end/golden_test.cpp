// The golden exchanges of tests/golden/rpc, each file played to a fresh daemon, over HTTP and over lines.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "server/daemon.h"
#include "tests/end_to_end/calls.h"

namespace selvage::test {
namespace {

// Equal but for "$any", and exactly the same fields.
bool alike(const Json& expected, const Json& actual) {
  if (expected == "$any") return true;
  if (!expected.is_object() || !actual.is_object()) return expected == actual;
  if (expected.size() != actual.size()) return false;
  for (const auto& [key, value] : expected.items()) {
    if (!actual.contains(key) || !alike(value, actual[key])) return false;
  }
  return true;
}

class GoldenExchanges : public ::testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(GoldenExchanges, AreWhatTheDaemonAnswers) {
  const auto& [name, road] = GetParam();
  const Json exchanges =
      Json::parse(file_text(std::string{SELVAGE_SOURCE_DIR} + "/tests/golden/rpc/" + name + ".json"));
  ASSERT_FALSE(exchanges.empty());
  Daemon daemon{on_free_port(1)};
  Wire wire{daemon.port()};
  for (const Json& exchange : exchanges) {
    const std::string request = to_text(exchange["request"]);
    std::string answer;
    if (road == std::string{"http"}) {
      answer = wire.post(request).value_or(HttpAnswer{}).body;
    } else {
      wire.send(request + "\n");
      answer = wire.line().value_or("");
    }
    ASSERT_FALSE(answer.empty()) << request;
    EXPECT_TRUE(alike(exchange["response"], Json::parse(answer)))
        << request << "\nexpected " << to_text(exchange["response"]) << "\nanswered " << answer;
  }
}

TEST(Readme, ExplainsEveryMethodOfTheDaemon) {
  const std::string text = file_text(std::string{SELVAGE_SOURCE_DIR} + "/protocol/README.md");
  Daemon daemon{on_free_port(1)};
  Wire wire{daemon.port()};
  const Json info = result_of(post_call(wire, "engine.info"));
  ASSERT_GT(info["methods"].size(), 20U);
  for (const Json& name : info["methods"]) {
    EXPECT_NE(text.find("| `" + name.get<std::string>() + "` |"), std::string::npos) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, GoldenExchanges,
                         ::testing::Combine(::testing::Values("life_of_a_marker", "mistakes", "motions", "changes",
                                                              "dragging", "places_and_tilts"),
                                            ::testing::Values("http", "lines")),
                         [](const auto& tested) {
                           return std::string{std::get<0>(tested.param)} + "_" + std::get<1>(tested.param);
                         });

}  // namespace
}  // namespace selvage::test
