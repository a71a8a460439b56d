// The golden exchanges of tests/golden/rpc, sent by the client to a live daemon over TCP and over a Unix socket.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "tests/clients/cpp/live_daemon.h"
#include "tests/support/repository.h"

namespace selvage::test {
namespace {

// Equal apart from "$any", and with exactly the same fields.
bool alike(const Json& expected, const Json& actual) {
  if (expected == "$any") return true;
  if (!expected.is_object() || !actual.is_object()) return expected == actual;
  if (expected.size() != actual.size()) return false;
  for (const auto& [key, value] : expected.items()) {
    if (!actual.contains(key) || !alike(value, actual[key])) return false;
  }
  return true;
}

Json as_response(const Answer& answer) {
  if (answer) return {{"result", *answer}};
  Json error{{"code", static_cast<int>(answer.error().code)}, {"message", answer.error().message}};
  if (!answer.error().details.is_null()) error["data"] = answer.error().details;
  return {{"error", error}};
}

// Whether the client can send the request: it always writes a correct JSON-RPC envelope.
bool is_a_call(const Json& request) {
  return request.is_object() && request["jsonrpc"] == "2.0" && !request["id"].is_object();
}

class GoldenExchanges : public ::testing::TestWithParam<std::tuple<const char*, bool>> {};

TEST_P(GoldenExchanges, ReachTheClientUnchanged) {
  const auto& [name, over_tcp] = GetParam();
  const Json exchanges = Json::parse(repository_text(std::string{"tests/golden/rpc/"} + name + ".json"));
  const LiveDaemon daemon;
  Client client{over_tcp ? daemon.tcp() : daemon.socket()};
  int played = 0;
  for (const Json& exchange : exchanges) {
    const Json& request = exchange["request"];
    if (!is_a_call(request)) continue;
    ++played;
    Json expected = exchange["response"];
    expected.erase("jsonrpc");
    expected.erase("id");
    const Json received =
        as_response(client.call(request["method"].get<std::string>(), request.value("params", Json::object())));
    EXPECT_TRUE(alike(expected, received)) << request << "\nexpected " << expected << "\nanswered " << received;
  }
  EXPECT_GE(played, 6);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenExchanges,
                         ::testing::Combine(::testing::Values("life_of_a_marker", "mistakes", "motions", "changes",
                                                              "dragging", "places_and_tilts", "allowances",
                                                              "cloth_rules", "cloth_repeat", "cloth_zones", "watching"),
                                            ::testing::Bool()),
                         [](const auto& tested) {
                           return std::string{std::get<0>(tested.param)} +
                                  (std::get<1>(tested.param) ? "_tcp" : "_unix");
                         });

}  // namespace
}  // namespace selvage::test
