// The engine embedded in a program gives the same answers as a daemon, byte for byte.
#include "clients/engine/engine.h"

#include <gtest/gtest.h>

#include <stop_token>
#include <string>
#include <vector>

#include "protocol/json/json_text.h"
#include "server/app/replay.h"
#include "tests/support/repository.h"

namespace selvage::engine {
namespace {

Json call_json(const std::string& method, Json params) {
  return {{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", std::move(params)}};
}
std::string answer(Engine& engine, const Json& request, const Caller& caller = {}) {
  return engine.answer(protocol::json::to_text(request), caller);
}
Json result(Engine& engine, const std::string& method, Json params) {
  return Json::parse(answer(engine, call_json(method, std::move(params))))["result"];
}
Json garment(const std::string& name) {
  return Json::parse(test::garment_text(name));
}

server::app::Options without_sockets() {
  server::app::Options options;
  options.task = server::app::Options::Task::kReplay;
  options.workers = 1;
  return options;
}

// Whether a program can make the call and the daemon's answer is the same.  This excludes calls about connections,
// retries and the daemon itself.
bool is_comparable(const Json& request) {
  if (!request.is_object() || !request.contains("method") || !request["method"].is_string()) return false;
  const std::string method = request["method"].get<std::string>();
  if (method == "engine.info" || method == "marker.watch" || method == "marker.unwatch") return false;
  if (method.starts_with("drag.") || method.starts_with("$") || method.starts_with("admin.")) return false;
  const Json params = request.value("params", Json::object());
  if (!params.is_object()) return true;
  return !params.contains("opId") && !params.contains("since") && !params.value("timing", false);
}

class GoldenRequests : public ::testing::TestWithParam<const char*> {};

TEST_P(GoldenRequests, AreAnsweredWithTheBytesOfADaemon) {
  const Json exchanges = Json::parse(test::repository_text(std::string{"tests/golden/rpc/"} + GetParam() + ".json"));
  server::app::Daemon daemon{without_sockets()};
  Engine engine{3};
  int compared = 0;
  for (const Json& exchange : exchanges) {
    const Json& request = exchange["request"];
    if (!is_comparable(request)) continue;
    const auto expected = server::app::replay(daemon, protocol::json::to_text(request));
    ASSERT_TRUE(expected);
    EXPECT_EQ(answer(engine, request), expected->answers.empty() ? "" : expected->answers.front()) << request;
    ++compared;
  }
  EXPECT_GE(compared, 4);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenRequests,
                         ::testing::Values("life_of_a_marker", "mistakes", "motions", "changes", "nesting",
                                           "places_and_tilts", "allowances"),
                         [](const auto& tested) { return std::string{tested.param}; });

TEST(Engine, CompactsAGarmentMarkerWithTheBytesOfADaemon) {
  server::app::Daemon daemon{without_sockets()};
  Engine engine{2};
  for (const Json& request :
       {call_json("marker.open", {{"marker", garment("jeans_02g")}}), call_json("motion.compact", {{"markerId", "m1"}}),
        call_json("marker.get", {{"markerId", "m1"}}), call_json("marker.get", {{"markerId", "m1"}, {"format", "svg"}}),
        call_json("marker.list", Json::object())}) {
    EXPECT_EQ(answer(engine, request), server::app::replay(daemon, protocol::json::to_text(request))->answers.front());
  }
}

TEST(Engine, ReportsEveryRound) {
  Engine engine{1};
  (void)result(engine, "marker.open", {{"marker", garment("jeans_02g")}});
  std::vector<double> lengths;
  Caller caller;
  caller.on_round = [&](const Round& round) {
    lengths.push_back(round.length);
    EXPECT_EQ(static_cast<std::size_t>(round.number), lengths.size());
    EXPECT_FALSE(round.bound || round.nodes);
  };
  const Json done = Json::parse(answer(engine, call_json("motion.compact", {{"markerId", "m1"}}), caller))["result"];
  ASSERT_EQ(lengths.size(), done["rounds"].get<std::size_t>());
  EXPECT_EQ(lengths.back(), done["lengthAfter"].get<double>());
}

TEST(Engine, ChangesNothingWhenTheCallerStopsTheCall) {
  Engine engine{1};
  (void)result(engine, "marker.open", {{"marker", garment("jeans_02g")}});
  std::stop_source stop;
  Caller caller{.stop = stop.get_token()};
  caller.on_round = [&](const Round&) { stop.request_stop(); };
  const Json refused = Json::parse(answer(engine, call_json("motion.compact", {{"markerId", "m1"}}), caller));
  EXPECT_EQ(refused["error"]["code"], -32800);
  EXPECT_EQ(result(engine, "marker.check", {{"markerId", "m1"}})["revision"], 1);
}

TEST(Engine, RefusesCallsThatNeedADaemon) {
  Engine engine{1};
  (void)result(engine, "marker.open", {{"marker", garment("jeans_02g")}});
  const Json refused = Json::parse(answer(engine, call_json("marker.watch", {{"markerId", "m1"}})));
  EXPECT_EQ(refused["error"]["code"], -32601);
  EXPECT_NE(refused["error"]["message"].get<std::string>().find("needs a daemon"), std::string::npos);
  const Json info = result(engine, "engine.info", Json::object());
  for (const Json& method : info["methods"]) EXPECT_NE(method, "marker.watch");
  EXPECT_EQ(info["markers"], 1);
}

}  // namespace
}  // namespace selvage::engine
