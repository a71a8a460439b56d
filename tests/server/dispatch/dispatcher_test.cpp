// Messages and their answers without sockets, executed inline where nothing has to wait.
#include "server/dispatch/dispatcher.h"

#include <gtest/gtest.h>

#include <future>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

TEST(Dispatcher, OpensCompactsChecksReadsAndClosesAMarker) {
  LocalServer local;
  const Json opened = local.ask_json(call(1, "marker.open", R"({"marker":)" + kSmallMarker + "}"));
  EXPECT_EQ(opened["id"], 1);
  EXPECT_EQ(opened["result"]["markerId"], "m1");
  EXPECT_EQ(opened["result"]["revision"], 1);
  EXPECT_EQ(opened["result"]["length"], 5);
  EXPECT_EQ(opened["result"]["valid"], true);
  const Json compacted = local.ask_json(call(2, "motion.compact", R"({"markerId":"m1","baseRev":1})"));
  EXPECT_EQ(compacted["result"]["revision"], 2);
  EXPECT_EQ(compacted["result"]["lengthAfter"], 4);
  EXPECT_EQ(compacted["result"]["placements"].size(), 2U);
  const Json checked = local.ask_json(call(3, "marker.check", R"({"markerId":"m1"})"));
  EXPECT_EQ(checked["result"]["valid"], true);
  EXPECT_EQ(checked["result"]["revision"], 2);
  const Json got = local.ask_json(call(4, "marker.get", R"({"markerId":"m1"})"));
  EXPECT_EQ(got["result"]["marker"]["pieces"][0]["at"], Json::parse("[2,0]"));
  EXPECT_EQ(local.ask_json(call(5, "marker.close", R"({"markerId":"m1"})"))["result"]["closed"], true);
  EXPECT_EQ(code_of(local.ask_json(call(6, "marker.get", R"({"markerId":"m1"})"))), -32012);
}

TEST(Dispatcher, EngineInfoReportsTheLimits) {
  LocalServer local;
  (void)local.open_small();
  const Json info = local.ask_json(call(1, "engine.info"))["result"];
  EXPECT_EQ(info["markers"], 1);
  EXPECT_EQ(info["version"], SELVAGE_VERSION);
  EXPECT_EQ(info["limits"]["markersBytes"], std::size_t{1232} << 20);
  EXPECT_EQ(info["limits"]["batch"], 100);
  EXPECT_EQ(info["cache"]["limit"], 1 << 20);
}

TEST(Dispatcher, EngineInfoReportsEveryLimitAsConfigured) {
  server::calls::Limits limits{.markers_bytes = 1'000'001,
                               .marker_bytes = 100'001,
                               .waiting_motions = 2,
                               .waiting_reads = 3,
                               .waiting_moves = 4,
                               .call = std::chrono::milliseconds{5},
                               .transport = {}};
  limits.transport.body_bytes = 100'006;
  limits.transport.connections = 7;
  limits.transport.calls_per_connection = 8;
  LocalServer local{0, pushing_methods(), limits};
  const Json reported = local.result("engine.info", "{}")["limits"];
  const Json expected{{"requestBytes", 100'006},
                      {"batch", 100},
                      {"depth", protocol::json::kMaxDepth},
                      {"values", protocol::json::most_values(100'006)},
                      {"pieces", marker::kMaxPieces},
                      {"vertices", geometry::kMaxVertices},
                      {"markersBytes", 1'000'001},
                      {"markerBytes", 100'001},
                      {"waitingMotions", 2},
                      {"waitingReads", 3},
                      {"waitingMoves", 4},
                      {"callMs", 5},
                      {"dragsPerConnection", 16},
                      {"connections", 7},
                      {"callsPerConnection", 8}};
  EXPECT_EQ(reported, expected);
}

TEST(Dispatcher, ABatchIsExecutedInOrderAndContinuesAfterAFailure) {
  LocalServer local;
  const std::string batch = "[" + call(1, "marker.open", R"({"marker":)" + kSmallMarker + "}") + "," +
                            call(2, "nothing.here") + "," + call(3, "motion.compact", R"({"markerId":"m1"})") + ",7," +
                            R"({"jsonrpc":"2.0","method":"motion.compact","params":{"markerId":"m1"}},)" +
                            call(4, "motion.compact", R"({"markerId":"m1"})") + "]";
  const Json answers = local.ask_json(batch);
  ASSERT_EQ(answers.size(), 5U);  // none for the notification, which was executed
  EXPECT_EQ(answers[0]["result"]["markerId"], "m1");
  EXPECT_EQ(code_of(answers[1]), -32601);
  EXPECT_EQ(answers[2]["result"]["revision"], 2);
  EXPECT_EQ(code_of(answers[3]), -32600);
  EXPECT_EQ(answers[4]["result"]["revision"], 4);
}

TEST(Dispatcher, ABatchIsExecutedInOrderOnWorkersToo) {
  LocalServer local{2};
  std::string batch = "[" + call(0, "marker.open", R"({"marker":)" + kSmallMarker + "}");
  for (int i = 1; i < 100; ++i) {
    batch += "," + call(i, i % 2 == 0 ? "marker.get" : "motion.compact", R"({"markerId":"m1"})");
  }
  const Json answers = local.ask_json(batch + "]");
  ASSERT_EQ(answers.size(), 100U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(answers[static_cast<std::size_t>(i)]["id"], i);
  EXPECT_EQ(answers[6]["result"]["revision"], 4);
}

TEST(Dispatcher, InvalidMessagesAreRefused) {
  LocalServer local;
  EXPECT_EQ(code_of(local.ask_json("")), -32700);
  EXPECT_EQ(code_of(local.ask_json("{")), -32700);
  EXPECT_EQ(code_of(local.ask_json(std::string(100'000, '['))), -32700);
  EXPECT_EQ(code_of(local.ask_json("[]")), -32600);
  EXPECT_EQ(code_of(local.ask_json(R"({"jsonrpc":"1.0","id":1,"method":"engine.info"})")), -32600);
  std::string batch = "[" + call(0, "engine.info");
  for (int i = 0; i < 100; ++i) batch += "," + call(i, "engine.info");
  EXPECT_EQ(code_of(local.ask_json(batch + "]")), -32600);
  EXPECT_EQ(code_of(local.ask_json(call(1, "engine.info", R"({"x":1})"))), -32602);
  EXPECT_EQ(local.ask(R"({"jsonrpc":"2.0","method":"engine.info"})"), "");
  EXPECT_EQ(local.ask(R"([{"jsonrpc":"2.0","method":"nothing.here"}])"), "");
}

TEST(Dispatcher, ADecoderThatThrowsFailsItsCallOnly) {
  MethodTable methods = protocol::methods::method_table();
  protocol::calls::Method throwing = *methods.find("engine.info");
  throwing.read = [](const Json&) -> Result<protocol::calls::ParsedCall> { throw std::runtime_error{"on purpose"}; };
  methods.replace(std::move(throwing));
  LocalServer local{0, methods};
  const Json answers = local.ask_json("[" + call(1, "engine.info") + "," + call(2, "marker.list") + "]");
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(code_of(answers[0]), -32603);
  EXPECT_EQ(answers[1]["result"]["markers"].size(), 0U);
}

TEST(Dispatcher, TheMemoryOfMarkersIsLimited) {
  server::calls::Limits limits;
  limits.markers_bytes = 50'000;
  LocalServer local{0, pushing_methods(), limits};
  const std::string opening = call(1, "marker.open", R"({"marker":)" + kSmallMarker + "}");
  Json answer;
  int opened = 0;
  while ((answer = local.ask_json(opening)).contains("result")) ++opened;
  EXPECT_GT(opened, 1);
  EXPECT_EQ(code_of(answer), -32013);
  EXPECT_EQ(answer["error"]["data"]["limit"], 50'000);
  EXPECT_TRUE(local.result("motion.compact", "{'markerId':'m1'}").contains("revision"));
  EXPECT_EQ(local.result("marker.close", "{'markerId':'m1'}")["closed"], true);
  EXPECT_TRUE(local.ask_json(opening).contains("result"));
}

TEST(Dispatcher, TheMemoryOfOneMarkerIsLimited) {
  server::calls::Limits limits;
  limits.marker_bytes = 10'000;
  LocalServer local{0, pushing_methods(), limits};
  (void)local.open_small();
  std::string shape = "{'id':'large','outline':[";
  for (int k = 0; k < 1000; ++k)
    shape += (k == 0 ? "[" : ",[") + std::to_string(k / 500.0) + "," + std::to_string(k / 500.0 * k / 500.0) + "]";
  const Json answer = local.result("marker.apply",
                                   "{'markerId':'m1','ops':[{'op':'add','piece':{'id':'new',"
                                   "'shape':'large','at':[5,5]},'shape':" +
                                       shape + "]}}]}");
  EXPECT_EQ(code_of(answer), -32013) << answer;
  EXPECT_EQ(answer["error"]["data"]["limit"], 10'000);
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
}

TEST(Dispatcher, EngineInfoListsEveryMethod) {
  LocalServer local;
  std::set<std::string> reported;
  const Json info = local.ask_json(call(1, "engine.info"))["result"];
  for (const Json& name : info["methods"]) reported.insert(name.get<std::string>());
  std::set<std::string> expected{"engine.info", "marker.open",  "marker.close",   "marker.list",    "marker.apply",
                                 "marker.undo", "marker.redo",  "marker.watch",   "marker.unwatch", "drag.begin",
                                 "drag.move",   "drag.end",     "rpc.discover",   "admin.backup",   "library.add",
                                 "library.get", "library.list", "library.remove", "library.search"};
  for (const protocol::calls::Method& method : protocol::methods::method_table().all()) {
    if (method.on_marker) expected.emplace(method.name);
  }
  EXPECT_EQ(reported, expected);
  for (const std::string& name : reported) EXPECT_TRUE(server::methods::HandlerTable{}.find(name)) << name;
}

TEST(Dispatcher, AFullQueueReportsWhenToRetry) {
  Gate gate;
  server::calls::Limits limits;
  limits.waiting_motions = 2;
  LocalServer local{1, gate.methods(), limits};
  const std::string params = R"({"markerId":")" + local.open_small() + R"("})";
  std::vector<std::future<std::string>> accepted;
  accepted.push_back(local.send(call(0, "motion.compact", params)));
  gate.await_arrivals(1);
  accepted.push_back(local.send(call(1, "motion.compact", params)));
  accepted.push_back(local.send(call(2, "motion.compact", params)));
  const Json refused = local.ask_json(call(3, "motion.compact", params));
  EXPECT_EQ(code_of(refused), -32010);
  EXPECT_GT(refused["error"]["data"]["retryAfterMs"].get<int>(), 0);
  EXPECT_EQ(refused["id"], 3);
  EXPECT_EQ(local.ask_json(call(4, "marker.get", params))["result"]["revision"], 1);
  gate.open();
  for (auto& answer : accepted) EXPECT_TRUE(Json::parse(answer.get()).contains("result"));
}

}  // namespace
}  // namespace selvage::test
