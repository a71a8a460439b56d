// Messages in, answers out, without sockets; inline where nothing has to wait.
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

TEST(Dispatcher, AMarkersLife) {
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

TEST(Dispatcher, TellsItsLimits) {
  LocalServer local;
  (void)local.open_small();
  const Json info = local.ask_json(call(1, "engine.info"))["result"];
  EXPECT_EQ(info["markers"], 1);
  EXPECT_EQ(info["version"], SELVAGE_VERSION);
  EXPECT_EQ(info["limits"]["openMarkers"], 1000);
  EXPECT_EQ(info["limits"]["batch"], 100);
  EXPECT_EQ(info["cache"]["limit"], 1 << 20);
}

TEST(Dispatcher, TellsEveryLimitAsItIsSet) {
  server::calls::Limits limits{.open_markers = 1,
                               .waiting_motions = 2,
                               .waiting_reads = 3,
                               .waiting_moves = 4,
                               .call = std::chrono::milliseconds{5},
                               .transport = {}};
  limits.transport.body_bytes = 100'006;
  limits.transport.connections = 7;
  limits.transport.calls_per_connection = 8;
  LocalServer local{0, pushing_methods(), limits};
  const Json told = local.result("engine.info", "{}")["limits"];
  const Json expected{{"requestBytes", 100'006},
                      {"batch", 100},
                      {"depth", protocol::json::kMaxDepth},
                      {"values", protocol::json::most_values(100'006)},
                      {"pieces", marker::kMaxPieces},
                      {"vertices", geometry::kMaxVertices},
                      {"openMarkers", 1},
                      {"waitingMotions", 2},
                      {"waitingReads", 3},
                      {"waitingMoves", 4},
                      {"callMs", 5},
                      {"dragsPerConnection", 16},
                      {"connections", 7},
                      {"callsPerConnection", 8}};
  EXPECT_EQ(told, expected);
}

TEST(Dispatcher, ACloseIsRetriedForItsOwnMarkerOnly) {
  LocalServer local;
  (void)local.open_small();
  (void)local.open_small();
  const Json closed = local.result("marker.close", "{'markerId':'m2','opId':'a'}");
  EXPECT_EQ(closed["closed"], true);
  EXPECT_EQ(local.result("marker.close", "{'markerId':'m2','opId':'a'}"), closed);
  EXPECT_EQ(local.result("marker.close", "{'markerId':'m1','opId':'a'}")["error"]["data"]["field"], "/opId");
  EXPECT_TRUE(local.store().current("m1"));
  EXPECT_EQ(local.result("marker.get", "{'markerId':'m2'}")["error"]["data"]["field"], "/markerId");
}

TEST(Dispatcher, AnotherRevisionThanTheBaseIsRefusedAndChangesNothing) {
  LocalServer local;
  const std::string compact = call(1, "motion.compact", R"({"markerId":")" + local.open_small() + R"(","baseRev":1})");
  EXPECT_EQ(local.ask_json(compact)["result"]["revision"], 2);
  const Json again = local.ask_json(compact);
  EXPECT_EQ(code_of(again), -32801);
  EXPECT_EQ(again["error"]["data"]["revision"], 2);
  EXPECT_EQ(local.store().current("m1")->revision, 2U);
}

TEST(Dispatcher, ADryRunAnswersAndLeavesTheMarker) {
  LocalServer local;
  const std::string id = local.open_small();
  const Json dry = local.ask_json(call(1, "motion.compact", R"({"markerId":")" + id + R"(","commit":false})"));
  EXPECT_EQ(dry["result"]["lengthAfter"], 4);
  EXPECT_EQ(dry["result"]["revision"], 1);
  EXPECT_EQ(local.store().current(id)->revision, 1U);
}

TEST(Dispatcher, AMotionThatMovesNothingMakesNoRevision) {
  LocalServer local;
  const std::string compact = call(1, "motion.compact", R"({"markerId":")" + local.open_small() + R"("})");
  for (int i = 0; i < 3; ++i) (void)local.ask(compact);
  EXPECT_EQ(local.store().current("m1")->revision, 4U);
  const Json last = local.ask_json(compact);
  EXPECT_EQ(last["result"]["revision"], 4);
  EXPECT_TRUE(last["result"]["placements"].empty());
}

TEST(Dispatcher, TimesAreToldOnlyWhenAsked) {
  LocalServer local;
  const std::string id = local.open_small();
  const std::string start = R"({"markerId":")" + id + R"(","commit":false)";
  const std::string plain = local.ask(call(1, "motion.compact", start + "}"));
  EXPECT_EQ(plain, local.ask(call(1, "motion.compact", start + R"(,"timing":false})")));
  EXPECT_FALSE(Json::parse(plain)["result"].contains("ms"));
  EXPECT_FALSE(Json::parse(plain)["result"].contains("cache"));
  const Json timed = local.ask_json(call(1, "motion.compact", start + R"(,"timing":true})"));
  EXPECT_GE(timed["result"]["ms"]["total"].get<double>(), 0);
  const Json wrong = local.ask_json(call(1, "motion.compact", start + R"(,"timing":1})"));
  EXPECT_EQ(code_of(wrong), -32602);
  EXPECT_EQ(wrong["error"]["data"]["field"], "/timing");
}

TEST(Dispatcher, BatchesGoInOrderAndAFailureStopsNothing) {
  LocalServer local;
  const std::string batch = "[" + call(1, "marker.open", R"({"marker":)" + kSmallMarker + "}") + "," +
                            call(2, "nothing.here") + "," + call(3, "motion.compact", R"({"markerId":"m1"})") + ",7," +
                            R"({"jsonrpc":"2.0","method":"motion.compact","params":{"markerId":"m1"}},)" +
                            call(4, "motion.compact", R"({"markerId":"m1"})") + "]";
  const Json answers = local.ask_json(batch);
  ASSERT_EQ(answers.size(), 5U);  // the notification has none, but was carried out
  EXPECT_EQ(answers[0]["result"]["markerId"], "m1");
  EXPECT_EQ(code_of(answers[1]), -32601);
  EXPECT_EQ(answers[2]["result"]["revision"], 2);
  EXPECT_EQ(code_of(answers[3]), -32600);
  EXPECT_EQ(answers[4]["result"]["revision"], 4);
}

TEST(Dispatcher, BatchesKeepTheirOrderOnWorkersToo) {
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

TEST(Dispatcher, MessagesThatAreNoCalls) {
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

TEST(Dispatcher, AnEngineThatThrowsFailsItsCallOnly) {
  for (const std::size_t workers : {0U, 1U}) {
    protocol::calls::Engine engine;
    engine.compact = [](auto&&...) -> Result<motion::compaction::Compaction> {
      throw std::runtime_error{"on purpose"};
    };
    LocalServer local{workers, engine};
    const std::string id = local.open_small();
    const Json answer = local.ask_json(call(1, "motion.compact", R"({"markerId":")" + id + R"("})"));
    EXPECT_EQ(code_of(answer), -32603);
    EXPECT_EQ(answer["id"], 1);
    EXPECT_EQ(local.ask_json(call(2, "marker.check", R"({"markerId":"m1"})"))["result"]["valid"], true);
  }
}

TEST(Dispatcher, AnEngineThatRefusesSaysWhy) {
  protocol::calls::Engine engine;
  engine.compact = [](auto&&...) -> Result<motion::compaction::Compaction> {
    return Error{ErrorCode::kMarkerOverlaps, "pieces low and high overlap", "/pieces/0"};
  };
  LocalServer local{0, engine};
  const std::string id = local.open_small();
  const Json answer = local.ask_json(call(1, "motion.compact", R"({"markerId":")" + id + R"("})"));
  EXPECT_EQ(code_of(answer), -32000);
  EXPECT_EQ(answer["error"]["data"]["name"], "marker.overlaps");
}

TEST(Dispatcher, TooManyOpenMarkers) {
  server::calls::Limits limits;
  limits.open_markers = 1;
  LocalServer local{0, pushing_methods(), limits};
  (void)local.open_small();
  const Json answer = local.ask_json(call(1, "marker.open", R"({"marker":)" + kSmallMarker + "}"));
  EXPECT_EQ(code_of(answer), -32013);
  EXPECT_EQ(answer["error"]["data"]["limit"], 1);
}

TEST(Dispatcher, OneMarkersMotionsTakeTurnsAndReadsDoNotWait) {
  Gate gate;
  LocalServer local{2, gate.methods()};
  const std::string id = local.open_small();
  const std::string params = R"({"markerId":")" + id + R"("})";
  auto first = local.send(call(1, "motion.compact", params));
  auto second = local.send(call(2, "motion.compact", params));
  gate.await_arrivals(1);
  EXPECT_EQ(local.ask_json(call(3, "marker.get", params))["result"]["revision"], 1);
  EXPECT_EQ(local.ask_json(call(4, "marker.check", params))["result"]["revision"], 1);
  gate.open();
  EXPECT_EQ(Json::parse(first.get())["result"]["revision"], 2);
  EXPECT_EQ(Json::parse(second.get())["result"]["revision"], 3);
  EXPECT_EQ(gate.most_at_once(), 1);
}

TEST(Dispatcher, TheSecondOfTwoMotionsOnOneBaseFindsItGone) {
  Gate gate;
  LocalServer local{2, gate.methods()};
  const std::string params = R"({"markerId":")" + local.open_small() + R"(","baseRev":1})";
  auto first = local.send(call(1, "motion.compact", params));
  auto second = local.send(call(2, "motion.compact", params));
  gate.await_arrivals(1);
  gate.open();
  EXPECT_EQ(Json::parse(first.get())["result"]["revision"], 2);
  EXPECT_EQ(code_of(Json::parse(second.get())), -32801);
}

// The motions on one marker, whichever they are, obey the same rules.
constexpr const char* kBumpRight = R"(,"piece":"low","direction":[0,1])";
constexpr const char* kFall = R"(,"force":[0,-1])";

TEST(Dispatcher, ABumpIsAnsweredCommittedAndCounted) {
  LocalServer local;
  const std::string start = R"({"markerId":")" + local.open_small() + "\"" + kBumpRight;
  const Json dry = local.ask_json(call(1, "motion.bump", start + R"(,"commit":false})"))["result"];
  EXPECT_EQ(dry["at"], Json::parse("[3,2]"));  // up to the high square
  EXPECT_EQ(dry["touching"], Json::parse(R"(["high"])"));
  EXPECT_EQ(dry["revision"], 1);
  const Json done = local.ask_json(call(2, "motion.bump", start + R"(,"baseRev":1})"))["result"];
  EXPECT_EQ(done["revision"], 2);
  EXPECT_EQ(done["gain"], 2);
  EXPECT_EQ(code_of(local.ask_json(call(3, "motion.bump", start + R"(,"baseRev":1})"))), -32801);
  const Json again = local.ask_json(call(4, "motion.bump", start + R"(,"baseRev":2})"))["result"];
  EXPECT_EQ(again["moved"], false);
  EXPECT_EQ(again["revision"], 2);
  const Json got = local.ask_json(call(5, "marker.get", R"({"markerId":"m1"})"))["result"];
  EXPECT_EQ(got["marker"]["pieces"][0]["at"], Json::parse("[3,2]"));
}

TEST(Dispatcher, AMistakeAboutAPieceIsAWrongParameter) {
  LocalServer local;
  const std::string start = R"({"markerId":")" + local.open_small() + "\"";
  const Json bump = local.ask_json(call(1, "motion.bump", start + R"(,"piece":"no","direction":[1,0]})"));
  EXPECT_EQ(code_of(bump), -32602);
  EXPECT_EQ(bump["error"]["data"]["field"], "/piece");
  const Json push = local.ask_json(call(2, "motion.push", start + R"(,"forces":[{"piece":"no","force":[1,0]}]})"));
  EXPECT_EQ(push["error"]["data"]["field"], "/forces/0/piece");
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
  EXPECT_EQ(code_of(local.ask_json(call(3, "motion.bump", R"({"markerId":"m9","piece":"low","direction":[1,0]})"))),
            -32012);
}

TEST(Dispatcher, MotionsOfDifferentKindsTakeTurns) {
  Gate gate;
  LocalServer local{2, gate.methods()};
  const std::string start = R"({"markerId":")" + local.open_small() + "\"";
  auto falling = local.send(call(1, "motion.gravity", start + kFall + "}"));
  gate.await_arrivals(1);
  auto compacting = local.send(call(2, "motion.compact", start + "}"));
  auto bumping = local.send(call(3, "motion.bump", start + kBumpRight + "}"));
  gate.open();
  EXPECT_EQ(Json::parse(falling.get())["result"]["revision"], 2);
  EXPECT_EQ(Json::parse(compacting.get())["result"]["revision"], 3);
  EXPECT_EQ(Json::parse(bumping.get())["result"]["revision"], 4);
  EXPECT_EQ(gate.most_at_once(), 1);
}

TEST(Dispatcher, ACallerWhoLeavesStopsItsPush) {
  Gate gate;
  LocalServer local{1, gate.methods()};
  const std::string start = R"({"markerId":")" + local.open_small() + "\"";
  Client leaving;
  auto running = local.send(call(1, "motion.gravity", start + kFall + "}"), leaving.session());
  gate.await_arrivals(1);
  leaving.disconnect();
  EXPECT_EQ(code_of(Json::parse(running.get())), -32800);
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
}

TEST(Dispatcher, ListsEveryMethodThatItHas) {
  LocalServer local;
  std::set<std::string> told;
  const Json info = local.ask_json(call(1, "engine.info"))["result"];
  for (const Json& name : info["methods"]) told.insert(name.get<std::string>());
  std::set<std::string> expected{"engine.info", "marker.open", "marker.close", "marker.list",    "marker.apply",
                                 "marker.undo", "marker.redo", "marker.watch", "marker.unwatch", "drag.begin",
                                 "drag.move",   "drag.end",    "rpc.discover"};
  for (const protocol::calls::MarkerMethod& method : protocol::methods::marker_methods()) expected.emplace(method.name);
  EXPECT_EQ(told, expected);
  for (const std::string& name : told) EXPECT_TRUE(server::methods::runs_on(name)) << name;
}

TEST(Dispatcher, DifferentMarkersMoveAtTheSameTime) {
  Gate gate;
  LocalServer local{2, gate.methods()};
  auto first = local.send(call(1, "motion.compact", R"({"markerId":")" + local.open_small() + R"("})"));
  auto second = local.send(call(2, "motion.compact", R"({"markerId":")" + local.open_small() + R"("})"));
  gate.await_arrivals(2);  // both are in, though the gate is shut
  gate.open();
  EXPECT_EQ(Json::parse(first.get())["result"]["revision"], 2);
  EXPECT_EQ(Json::parse(second.get())["result"]["revision"], 2);
}

TEST(Dispatcher, AFullQueueSaysWhenToComeAgain) {
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
  EXPECT_GT(refused["error"]["data"]["retryAfterMs"], 0);
  EXPECT_EQ(refused["id"], 3);
  EXPECT_EQ(local.ask_json(call(4, "marker.get", params))["result"]["revision"], 1);
  gate.open();
  for (auto& answer : accepted) EXPECT_TRUE(Json::parse(answer.get()).contains("result"));
}

TEST(Dispatcher, ACallerWhoLeavesStopsItsMotionAndNothingIsCommitted) {
  Gate gate;
  LocalServer local{1, gate.methods()};
  const std::string params = R"({"markerId":")" + local.open_small() + R"("})";
  Client leaving;
  auto running = local.send(call(1, "motion.compact", params), leaving.session());
  auto waiting = local.send(call(2, "motion.compact", params), leaving.session());
  gate.await_arrivals(1);
  leaving.disconnect();
  EXPECT_EQ(code_of(Json::parse(running.get())), -32800);
  EXPECT_EQ(code_of(Json::parse(waiting.get())), -32800);
  EXPECT_EQ(gate.arrived(), 1);  // the second never began
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
}

TEST(Dispatcher, AMarkerClosedUnderAMotionIsGone) {
  Gate gate;
  LocalServer local{1, gate.methods()};
  const std::string params = R"({"markerId":")" + local.open_small() + R"("})";
  auto running = local.send(call(1, "motion.compact", params));
  gate.await_arrivals(1);
  EXPECT_EQ(local.ask_json(call(2, "marker.close", params))["result"]["closed"], true);
  gate.open();
  EXPECT_EQ(code_of(Json::parse(running.get())), -32012);
}

TEST(Dispatcher, DrainingHandsBackTheBestAndRefusesWhatIsNew) {
  Gate gate;
  LocalServer local{1, gate.methods()};
  const std::string params = R"({"markerId":")" + local.open_small() + R"("})";
  auto running = local.send(call(1, "motion.compact", params));
  auto waiting = local.send(call(2, "motion.compact", params));
  gate.await_arrivals(1);
  local.backend.queues().motions.drain();
  const Json best = Json::parse(running.get());
  EXPECT_EQ(best["result"]["stop"], "cancelled");
  EXPECT_EQ(best["result"]["revision"], 2);  // its caller is there and told, so it counts
  EXPECT_EQ(Json::parse(waiting.get())["result"]["stop"], "cancelled");
  EXPECT_EQ(code_of(local.ask_json(call(3, "motion.compact", params))), -32014);
}

}  // namespace
}  // namespace selvage::test
