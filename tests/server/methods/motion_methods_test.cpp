// Motions through the server: commits, refusals, lanes, and callers that disconnect.
#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <string>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

constexpr const char* kBumpRight = R"(,"piece":"low","direction":[0,1])";
constexpr const char* kFall = R"(,"force":[0,-1])";

TEST(MotionMethods, AWrongBaseRevisionIsRefusedAndChangesNothing) {
  LocalServer local;
  const std::string compact = call(1, "motion.compact", R"({"markerId":")" + local.open_small() + R"(","baseRev":1})");
  EXPECT_EQ(local.ask_json(compact)["result"]["revision"], 2);
  const Json again = local.ask_json(compact);
  EXPECT_EQ(code_of(again), -32801);
  EXPECT_EQ(again["error"]["data"]["revision"], 2);
  EXPECT_EQ(local.store().current("m1")->revision, 2U);
}

TEST(MotionMethods, ADryRunLeavesTheMarkerUnchanged) {
  LocalServer local;
  const std::string id = local.open_small();
  const Json dry = local.ask_json(call(1, "motion.compact", R"({"markerId":")" + id + R"(","commit":false})"));
  EXPECT_EQ(dry["result"]["lengthAfter"], 4);
  EXPECT_EQ(dry["result"]["revision"], 1);
  EXPECT_EQ(local.store().current(id)->revision, 1U);
}

TEST(MotionMethods, AMotionThatMovesNothingCommitsNothing) {
  LocalServer local;
  const std::string compact = call(1, "motion.compact", R"({"markerId":")" + local.open_small() + R"("})");
  for (int i = 0; i < 3; ++i) (void)local.ask(compact);
  EXPECT_EQ(local.store().current("m1")->revision, 4U);
  const Json last = local.ask_json(compact);
  EXPECT_EQ(last["result"]["revision"], 4);
  EXPECT_TRUE(last["result"]["placements"].empty());
}

TEST(MotionMethods, TimesAreReportedOnRequestOnly) {
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

TEST(MotionMethods, AMotionThatThrowsFailsItsCallOnly) {
  const auto throwing = methods_with({"motion.compact"},
                                     [](auto&&...) -> Result<MethodAnswer> { throw std::runtime_error{"on purpose"}; });
  for (const std::size_t workers : {0U, 1U}) {
    LocalServer local{workers, throwing};
    const std::string id = local.open_small();
    const Json answer = local.ask_json(call(1, "motion.compact", R"({"markerId":")" + id + R"("})"));
    EXPECT_EQ(code_of(answer), -32603);
    EXPECT_EQ(answer["id"], 1);
    EXPECT_EQ(local.ask_json(call(2, "marker.check", R"({"markerId":"m1"})"))["result"]["valid"], true);
  }
}

TEST(MotionMethods, TheErrorOfARefusedMotionStatesTheReason) {
  LocalServer local{0, methods_with({"motion.compact"}, [](auto&&...) -> Result<MethodAnswer> {
                      return Error{ErrorCode::kMarkerOverlaps, "pieces low and high overlap", "/pieces/0"};
                    })};
  const std::string id = local.open_small();
  const Json answer = local.ask_json(call(1, "motion.compact", R"({"markerId":")" + id + R"("})"));
  EXPECT_EQ(code_of(answer), -32000);
  EXPECT_EQ(answer["error"]["data"]["name"], "marker.overlaps");
}

TEST(MotionMethods, MotionsOfOneMarkerRunOneAtATimeAndReadsDoNotWait) {
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

// Each takes as long as a motion, and leaves its marker as it is.
TEST(MotionMethods, WhileASearchRunsItsMarkerCanBeChangedAndLongReadsDoNotWait) {
  Gate gate;
  const auto searching = [&gate](const CommonParams& about, const MarkerFile& file,
                                 const MethodContext& context) -> Result<MethodAnswer> {
    auto answer = gate.run(about, file, context);
    if (answer) answer->next.reset();
    return answer;
  };
  LocalServer local{2, methods_with({"plan.cut", "marker.nestSheets"}, searching)};
  const std::string start = R"({"markerId":")" + local.open_small() + "\"";
  const std::string order = R"(,"quantities":[{"colour":"blue","size":"38","garments":1}]})";
  auto planning = local.send(call(1, "plan.cut", start + order));
  gate.await_arrivals(1);
  EXPECT_EQ(local.ask_json(call(2, "motion.compact", start + "}"))["result"]["revision"], 2);
  EXPECT_TRUE(local.ask_json(call(3, "motion.bump", start + kBumpRight + "}")).contains("result"));
  auto nesting = local.send(call(4, "marker.nestSheets", start + R"(,"sheets":[{"width":100,"length":100}]})"));
  gate.await_arrivals(2);  // both run, although they are about one marker
  EXPECT_EQ(local.ask_json(call(5, "marker.check", start + "}"))["result"]["valid"], true);
  gate.open();
  EXPECT_EQ(Json::parse(planning.get())["result"]["revision"], 1);
  EXPECT_EQ(Json::parse(nesting.get())["result"]["revision"], 2);
}

TEST(MotionMethods, TheSecondOfTwoMotionsOnOneRevisionIsRefused) {
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

TEST(MotionMethods, ABumpIsCommittedAndItsRevisionCounts) {
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

TEST(MotionMethods, AnUnknownPieceIsAnInvalidParameter) {
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

TEST(MotionMethods, MotionsOfDifferentKindsRunOneAtATime) {
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

TEST(MotionMethods, ADisconnectedCallerStopsItsPush) {
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

TEST(MotionMethods, MotionsOfDifferentMarkersRunAtTheSameTime) {
  Gate gate;
  LocalServer local{2, gate.methods()};
  auto first = local.send(call(1, "motion.compact", R"({"markerId":")" + local.open_small() + R"("})"));
  auto second = local.send(call(2, "motion.compact", R"({"markerId":")" + local.open_small() + R"("})"));
  gate.await_arrivals(2);  // both have started, although the gate is closed
  gate.open();
  EXPECT_EQ(Json::parse(first.get())["result"]["revision"], 2);
  EXPECT_EQ(Json::parse(second.get())["result"]["revision"], 2);
}

TEST(MotionMethods, ADisconnectedCallerStopsItsMotionsAndNothingIsCommitted) {
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
  EXPECT_EQ(gate.arrived(), 1);  // the second one never started
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
}

TEST(MotionMethods, AMotionFailsIfItsMarkerIsClosedMeanwhile) {
  Gate gate;
  LocalServer local{1, gate.methods()};
  const std::string params = R"({"markerId":")" + local.open_small() + R"("})";
  auto running = local.send(call(1, "motion.compact", params));
  gate.await_arrivals(1);
  EXPECT_EQ(local.ask_json(call(2, "marker.close", params))["result"]["closed"], true);
  gate.open();
  EXPECT_EQ(code_of(Json::parse(running.get())), -32012);
}

TEST(MotionMethods, DrainingReturnsTheBestResultsAndRefusesNewCalls) {
  Gate gate;
  LocalServer local{1, gate.methods()};
  const std::string params = R"({"markerId":")" + local.open_small() + R"("})";
  auto running = local.send(call(1, "motion.compact", params));
  auto waiting = local.send(call(2, "motion.compact", params));
  gate.await_arrivals(1);
  local.backend.queues().motions.drain();
  const Json best = Json::parse(running.get());
  EXPECT_EQ(best["result"]["stop"], "cancelled");
  EXPECT_EQ(best["result"]["revision"], 2);  // the caller receives the answer, so the result is committed
  EXPECT_EQ(Json::parse(waiting.get())["result"]["stop"], "cancelled");
  EXPECT_EQ(code_of(local.ask_json(call(3, "motion.compact", params))), -32014);
}

}  // namespace
}  // namespace selvage::test
