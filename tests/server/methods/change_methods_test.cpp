// Edits through the server: apply, undo and redo.
#include <gtest/gtest.h>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

Json at_of(LocalServer& local, std::size_t piece) {
  return local.result("marker.get", "{'markerId':'m1'}")["marker"]["pieces"][piece]["at"];
}

TEST(ChangeMethods, AnApplyIsOneRevisionAndReportsItsChanges) {
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

TEST(ChangeMethods, AnEditMayMakePiecesOverlapAndReportsIt) {
  LocalServer local;
  (void)local.open_small();
  const Json done = local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'move','piece':'low','at':[3,3]}]}");
  EXPECT_EQ(done["valid"], false);
  EXPECT_EQ(done["revision"], 2);
}

TEST(ChangeMethods, AnErrorInOneOperationRevertsAll) {
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

TEST(ChangeMethods, UndoAndRedoMakeNewRevisions) {
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
  EXPECT_EQ(again, first);  // the same bytes except for the revision
  EXPECT_EQ(code_of(local.result("marker.undo", "{'markerId':'m1'}")), -32000);
  (void)local.result("marker.redo", "{'markerId':'m1'}");
  EXPECT_EQ(local.result("marker.redo", "{'markerId':'m1'}")["removed"], Json::parse(R"(["low"])"));
  EXPECT_EQ(local.result("marker.redo", "{'markerId':'m1'}")["error"]["data"]["name"], "history.nothing_to_undo");
}

TEST(ChangeMethods, AMotionCanBeUndoneAndANewChangeClearsRedo) {
  LocalServer local;
  (void)local.open_small();
  (void)local.result("motion.compact", "{'markerId':'m1'}");
  EXPECT_EQ(at_of(local, 0), Json::parse("[2,0]"));
  (void)local.result("marker.undo", "{'markerId':'m1'}");
  EXPECT_EQ(at_of(local, 0), Json::parse("[3,0]"));
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'lock','piece':'low'}]}");
  EXPECT_EQ(code_of(local.result("marker.redo", "{'markerId':'m1'}")), -32000);
}

}  // namespace
}  // namespace selvage::test
