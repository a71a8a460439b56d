// Changes by hand through the dispatcher: apply, undo, redo; retries by opId; those who watch.
#include <gtest/gtest.h>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

Json at_of(LocalServer& local, std::size_t piece) {
  return local.result("marker.get", "{'markerId':'m1'}")["marker"]["pieces"][piece]["at"];
}

TEST(Changes, AnApplyIsOneRevisionAndTellsWhatItDid) {
  LocalServer local;
  (void)local.open_small();
  const Json done = local.result("marker.apply", R"({'markerId':'m1','baseRev':1,'ops':[
      {'op':'move','piece':'low','at':[0,1]},{'op':'move','piece':'low','by':[0.5,0]},
      {'op':'add','piece':{'id':'third','shape':'square','at':[7,7]}},{'op':'remove','piece':'high'}]})");
  EXPECT_EQ(done["revision"], 2);
  EXPECT_EQ(done["pieces"], 2);
  EXPECT_EQ(done["length"], 9);
  EXPECT_EQ(done["valid"], true);
  EXPECT_EQ(done["removed"], Json::parse(R"(["high"])"));
  ASSERT_EQ(done["placements"].size(), 2U);
  EXPECT_EQ(done["placements"][0]["id"], "low");
  EXPECT_EQ(done["placements"][0]["at"], Json::parse("[0.5,1]"));
  EXPECT_EQ(done["placements"][1]["id"], "third");
}

TEST(Changes, AnEditMayMakePiecesOverlapAndSaysSo) {
  LocalServer local;
  (void)local.open_small();
  const Json done = local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'move','piece':'low','at':[3,3]}]}");
  EXPECT_EQ(done["valid"], false);
  EXPECT_EQ(done["revision"], 2);
}

TEST(Changes, AMistakeInOneOperationUndoesThemAll) {
  LocalServer local;
  (void)local.open_small();
  const Json refused = local.result("marker.apply", R"({'markerId':'m1','ops':[
      {'op':'move','piece':'low','at':[0,0]},{'op':'rotate','piece':'high','to':30}]})");
  EXPECT_EQ(code_of(refused), -32602);
  EXPECT_EQ(refused["error"]["data"]["name"], "marker.orientation_not_allowed");
  EXPECT_EQ(refused["error"]["data"]["field"], "/ops/1");
  EXPECT_EQ(at_of(local, 0), Json::parse("[3,0]"));
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
}

TEST(Changes, UndoAndRedoGoBackAndForthAndAreRevisionsThemselves) {
  LocalServer local;
  (void)local.open_small();
  const std::string first = local.ask(call(1, "marker.get", R"({"markerId":"m1"})"));
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'move','piece':'low','at':[1,0]}]}");
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'remove','piece':'low'}]}");
  EXPECT_EQ(local.result("marker.undo", "{'markerId':'m1'}")["placements"][0]["id"], "low");
  EXPECT_EQ(at_of(local, 0), Json::parse("[1,0]"));
  const Json undone = local.result("marker.undo", "{'markerId':'m1'}");
  EXPECT_EQ(undone["revision"], 5);
  EXPECT_EQ(at_of(local, 0), Json::parse("[3,0]"));
  std::string again = local.ask(call(1, "marker.get", R"({"markerId":"m1"})"));
  again.replace(again.find(R"("revision":5)"), 12, R"("revision":1)");
  EXPECT_EQ(again, first);  // but for the revision, the same bytes
  EXPECT_EQ(code_of(local.result("marker.undo", "{'markerId':'m1'}")), -32000);
  (void)local.result("marker.redo", "{'markerId':'m1'}");
  EXPECT_EQ(local.result("marker.redo", "{'markerId':'m1'}")["removed"], Json::parse(R"(["low"])"));
  EXPECT_EQ(local.result("marker.redo", "{'markerId':'m1'}")["error"]["data"]["name"], "history.nothing_to_undo");
}

TEST(Changes, AMotionCanBeUndoneAndANewChangeEndsRedoing) {
  LocalServer local;
  (void)local.open_small();
  (void)local.result("motion.compact", "{'markerId':'m1'}");
  EXPECT_EQ(at_of(local, 0), Json::parse("[2,0]"));
  (void)local.result("marker.undo", "{'markerId':'m1'}");
  EXPECT_EQ(at_of(local, 0), Json::parse("[3,0]"));
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'lock','piece':'low'}]}");
  EXPECT_EQ(code_of(local.result("marker.redo", "{'markerId':'m1'}")), -32000);
}

TEST(Changes, SinceTellsOnlyWhatMoved) {
  LocalServer local;
  (void)local.open_small();
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'move','piece':'low','at':[1,0]}]}");
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'move','piece':'high','at':[1,4]}]}");
  const Json last = local.result("marker.get", "{'markerId':'m1','since':2}");
  EXPECT_FALSE(last.contains("marker"));
  ASSERT_EQ(last["placements"].size(), 1U);
  EXPECT_EQ(last["placements"][0]["id"], "high");
  EXPECT_EQ(local.result("marker.get", "{'markerId':'m1','since':1}")["placements"].size(), 2U);
  EXPECT_EQ(local.result("marker.get", "{'markerId':'m1','since':3}")["placements"].size(), 0U);
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'setSpacing','spacing':1}]}");
  EXPECT_TRUE(local.result("marker.get", "{'markerId':'m1','since':3}").contains("marker"));  // more than moves
  EXPECT_TRUE(local.result("marker.get", "{'markerId':'m1','since':99}").contains("marker"));
}

TEST(Changes, ListsWhatIsOpen) {
  LocalServer local;
  EXPECT_EQ(local.result("marker.list", "{}")["markers"].size(), 0U);
  (void)local.open_small();
  (void)local.open_small();
  (void)local.result("motion.compact", "{'markerId':'m2'}");
  const Json list = local.result("marker.list", "{}")["markers"];
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1]["markerId"], "m2");
  EXPECT_EQ(list[1]["revision"], 2);
  EXPECT_EQ(list[1]["length"], 4);
  EXPECT_EQ(list[0]["name"], "small");
}

TEST(Retries, GetTheSameAnswerAndDoNothingTwice) {
  LocalServer local;
  (void)local.open_small();
  const std::vector<std::pair<std::string, std::string>> calls{
      {"marker.apply", R"({"markerId":"m1","opId":"a","ops":[{"op":"move","piece":"low","by":[-1,0]}]})"},
      {"motion.compact", R"({"markerId":"m1","opId":"b"})"},
      {"marker.undo", R"({"markerId":"m1","opId":"c"})"},
      {"marker.redo", R"({"markerId":"m1","opId":"d"})"},
      {"motion.bump", R"({"markerId":"m1","opId":"e","piece":"low","direction":[0,1]})"},
      {"marker.close", R"({"markerId":"m1","opId":"f"})"}};
  for (const auto& [method, params] : calls) {
    const std::string first = local.ask(call(1, method, params));
    EXPECT_EQ(Json::parse(first).count("result"), 1U) << first;
    const auto revision = local.store().current("m1").value_or(server::store::Committed{}).revision;
    EXPECT_EQ(local.ask(call(1, method, params)), first);
    EXPECT_EQ(local.store().current("m1").value_or(server::store::Committed{}).revision, revision) << method;
  }
  const std::string open = call(1, "marker.open", R"({"opId":"o","marker":)" + kSmallMarker + "}");
  EXPECT_EQ(local.ask(open), local.ask(open));
  EXPECT_EQ(local.store().count(), 1U);
}

TEST(Retries, AnOpIdBelongsToOneMethodAndOneMarker) {
  LocalServer local;
  (void)local.open_small();
  (void)local.open_small();
  (void)local.result("motion.compact", "{'markerId':'m1','opId':'a'}");
  const Json other = local.result("marker.undo", "{'markerId':'m1','opId':'a'}");
  EXPECT_EQ(other["error"]["data"]["field"], "/opId");
  EXPECT_EQ(local.result("motion.compact", "{'markerId':'m2','opId':'a'}")["revision"], 2);
}

TEST(Retries, ARefusedCallMayBeTriedAgain) {
  LocalServer local;
  (void)local.open_small();
  EXPECT_EQ(code_of(local.result("motion.compact", "{'markerId':'m1','opId':'a','baseRev':7}")), -32801);
  EXPECT_EQ(local.result("motion.compact", "{'markerId':'m1','opId':'a','baseRev':1}")["revision"], 2);
}

TEST(Retries, OnlyTheLastAnswersAreKept) {
  server::store::KeptAnswers answers;
  for (std::size_t i = 0; i <= server::store::KeptAnswers::kMost; ++i) {
    answers.keep({std::to_string(i), "m", std::make_shared<const std::string>("{}")});
  }
  EXPECT_EQ(answers.find("0"), nullptr);
  EXPECT_NE(answers.find("1"), nullptr);
  EXPECT_NE(answers.find(std::to_string(server::store::KeptAnswers::kMost)), nullptr);
}

TEST(Watching, EveryWatcherHearsOfEveryRevisionInOrder) {
  LocalServer local;
  Client other;
  (void)local.open_small();
  EXPECT_EQ(local.result("marker.watch", "{'markerId':'m1'}")["revision"], 1);
  (void)local.ask(call(1, "marker.watch", R"({"markerId":"m1"})"), other.session());
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'move','piece':'low','at':[1,0]}]}");
  (void)local.result("motion.compact", "{'markerId':'m1'}");
  (void)local.result("marker.undo", "{'markerId':'m1'}");
  for (Client* client : {&local.client, &other}) {
    const Json applied = client->next();
    EXPECT_EQ(applied["method"], "marker.changed");
    EXPECT_FALSE(applied.contains("id"));
    EXPECT_EQ(applied["params"]["revision"], 2);
    EXPECT_EQ(applied["params"]["by"], "marker.apply");
    EXPECT_EQ(applied["params"]["placements"][0]["at"], Json::parse("[1,0]"));
    const Json moved = client->next();
    EXPECT_EQ(moved["params"]["revision"], 3);
    EXPECT_EQ(moved["params"]["by"], "motion.compact");
    EXPECT_EQ(moved["params"]["length"], 4);
    EXPECT_EQ(client->next()["params"]["by"], "marker.undo");
  }
  (void)local.result("marker.close", "{'markerId':'m1'}");
  EXPECT_EQ(other.next()["method"], "marker.closed");
  EXPECT_EQ(local.client.next()["params"]["markerId"], "m1");
}

TEST(Watching, EndsWhenItIsNoLongerWantedOrNobodyIsThere) {
  LocalServer local;
  Client leaving;
  (void)local.open_small();
  (void)local.result("marker.watch", "{'markerId':'m1'}");
  (void)local.ask(call(1, "marker.watch", R"({"markerId":"m1"})"), leaving.session());
  leaving.disconnect();
  EXPECT_EQ(local.result("marker.unwatch", "{'markerId':'m1'}")["watched"], true);
  EXPECT_EQ(local.result("marker.unwatch", "{'markerId':'m1'}")["watched"], false);
  (void)local.result("motion.compact", "{'markerId':'m1'}");
  EXPECT_EQ(local.client.pending(), 0U);
  EXPECT_EQ(leaving.pending(), 0U);
}

TEST(Watching, NeedsAConnectionThatCanBeNotified) {
  LocalServer local;
  Client deaf{false};
  (void)local.open_small();
  const Json answer = Json::parse(local.ask(call(1, "marker.watch", R"({"markerId":"m1"})"), deaf.session()));
  EXPECT_EQ(code_of(answer), -32600);
  EXPECT_EQ(code_of(local.result("marker.watch", "{'markerId':'m9'}")), -32012);
}

}  // namespace
}  // namespace selvage::test
