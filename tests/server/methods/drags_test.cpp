// The dragging hand, through the dispatcher.
#include <gtest/gtest.h>

#include "tests/server/dispatch/desk.h"

namespace selvage::test {
namespace {

TEST(Drags, FollowTheHandAndCommitOnceAtTheEnd) {
  Desk desk;
  (void)desk.open_small();
  const Json begun = desk.result("drag.begin", "{'markerId':'m1','piece':'low'}");
  EXPECT_EQ(begun["dragId"], "d1");
  EXPECT_EQ(begun["at"], Json::parse("[3,0]"));
  const Json free = desk.result("drag.move", "{'dragId':'d1','to':[7,1]}");
  EXPECT_EQ(free["at"], Json::parse("[7,1]"));
  EXPECT_EQ(free["reached"], true);
  const Json blocked = desk.result("drag.move", "{'dragId':'d1','to':[3,3]}");
  EXPECT_EQ(blocked["reached"], false);
  EXPECT_EQ(blocked["valid"], true);
  EXPECT_EQ(desk.store.current("m1")->revision, 1U);
  const Json ended = desk.result("drag.end", "{'dragId':'d1','markerId':'m1','opId':'x'}");
  EXPECT_EQ(ended["revision"], 2);
  EXPECT_EQ(ended["placements"][0]["at"], blocked["at"]);
  EXPECT_EQ(desk.result("drag.end", "{'dragId':'d1','markerId':'m1','opId':'x'}"), ended);
  EXPECT_EQ(desk.result("drag.move", "{'dragId':'d1','to':[7,1]}")["error"]["data"]["field"], "/dragId");
}

TEST(Drags, PushTheOthersOutOfTheWay) {
  Desk desk;
  (void)desk.open_small();
  (void)desk.result("drag.begin", "{'markerId':'m1','piece':'low','mode':'push'}");
  const Json moved = desk.result("drag.move", "{'dragId':'d1','to':[3,3]}");
  EXPECT_EQ(moved["at"], Json::parse("[3,3]"));
  EXPECT_EQ(moved["pushed"], true);
  EXPECT_EQ(moved["valid"], true);
  EXPECT_EQ(moved["placements"].size(), 2U);
  const Json left = desk.result("drag.end", "{'dragId':'d1','markerId':'m1','commit':false}");
  EXPECT_EQ(left["revision"], 1);
  EXPECT_EQ(desk.store.current("m1")->revision, 1U);
}

TEST(Drags, ALockedPieceStays) {
  Desk desk;
  (void)desk.open_small();
  (void)desk.result("marker.apply", "{'markerId':'m1','ops':[{'op':'lock','piece':'low'}]}");
  (void)desk.result("drag.begin", "{'markerId':'m1','piece':'low'}");
  EXPECT_EQ(desk.result("drag.move", "{'dragId':'d1','to':[7,1]}")["at"], Json::parse("[3,0]"));
}

TEST(Drags, AHandFarOutsideIsRefused) {
  Desk desk;
  (void)desk.open_small();
  (void)desk.result("drag.begin", "{'markerId':'m1','piece':'low'}");
  for (const char* far : {"[1e12,0]", "[0,-1e12]"}) {
    const Json answer = desk.result("drag.move", std::string{"{'dragId':'d1','to':"} + far + "}");
    EXPECT_EQ(code_of(answer), -32602) << far;
    EXPECT_EQ(answer["error"]["data"]["field"], "/to") << far;
  }
  EXPECT_EQ(desk.result("drag.move", "{'dragId':'d1','to':[7,1]}")["reached"], true);
}

TEST(Drags, AnEndThatChangesNothingIsKeptForItsRetry) {
  Desk desk;
  (void)desk.open_small();
  for (const char* commit : {"true", "false"}) {
    const Json begun = desk.result("drag.begin", "{'markerId':'m1','piece':'low'}");
    const std::string end = "{'dragId':'" + begun["dragId"].get<std::string>() + "','markerId':'m1','opId':'" + commit +
                            "','commit':" + commit + "}";
    if (std::string_view{commit} == "false") {
      (void)desk.result("drag.move", "{'dragId':'" + begun["dragId"].get<std::string>() + "','to':[7,1]}");
    }
    const Json ended = desk.result("drag.end", end);
    EXPECT_EQ(ended["revision"], 1);
    EXPECT_EQ(desk.result("drag.end", end), ended) << commit;
  }
}

// A hand whose moves wait until they are let through.
struct SlowHand {
  protocol::calls::Engine engine() {
    protocol::calls::Engine engine;
    engine.drag = [this](const Marker& start, const scene::LaidOut&, PieceId piece, Vec to, motion::dragging::DragMode,
                         const scene::Run&) {
      {
        const std::lock_guard lock{mutex};
        ++begun;
        changed.notify_all();
      }
      std::unique_lock lock{mutex};
      changed.wait_for(lock, kPatience, [this] { return open; });
      motion::dragging::Drag moved{start, false};
      moved.marker.pieces[piece.value].at = to;
      return moved;
    };
    return engine;
  }
  void await_begun(int count) {
    std::unique_lock lock{mutex};
    ASSERT_TRUE(changed.wait_for(lock, kPatience, [&] { return begun >= count; }));
  }
  void let_through() {
    const std::lock_guard lock{mutex};
    open = true;
    changed.notify_all();
  }
  std::mutex mutex;
  std::condition_variable changed;
  bool open{};
  int begun{};
};

TEST(Drags, TheLatestMoveWinsAndTheSupersededAreAnswered) {
  SlowHand hand;
  Desk desk{1, hand.engine()};
  (void)desk.open_small();
  (void)desk.result("drag.begin", "{'markerId':'m1','piece':'low'}");
  std::vector<std::future<std::string>> moves;
  moves.push_back(desk.send(call(0, "drag.move", R"({"dragId":"d1","to":[0,0]})")));
  hand.await_begun(1);
  for (int i = 1; i < 50; ++i) {
    moves.push_back(desk.send(call(i, "drag.move", R"({"dragId":"d1","to":[)" + std::to_string(i) + ",0]}")));
  }
  for (std::size_t i = 1; i < 49; ++i) EXPECT_EQ(code_of(Json::parse(moves[i].get())), -32802);
  auto end = desk.send(call(50, "drag.end", R"({"dragId":"d1","markerId":"m1"})"));
  hand.let_through();
  EXPECT_EQ(Json::parse(moves[0].get())["result"]["at"], Json::parse("[0,0]"));
  EXPECT_EQ(Json::parse(moves[49].get())["result"]["at"], Json::parse("[49,0]"));
  const Json ended = Json::parse(end.get());
  EXPECT_EQ(ended["result"]["placements"][0]["at"], Json::parse("[49,0]"));
  EXPECT_EQ(hand.begun, 2);
}

TEST(Drags, AnEndThatIsRefusedAsBusyMayBeSentAgain) {
  SlowHand hand;
  server::calls::Limits limits;
  limits.waiting_moves = 1;
  Desk desk{1, hand.engine(), limits};
  (void)desk.open_small();
  (void)desk.result("drag.begin", "{'markerId':'m1','piece':'low'}");
  (void)desk.result("drag.begin", "{'markerId':'m1','piece':'high'}");
  auto holds_the_worker = desk.send(call(1, "drag.move", R"({"dragId":"d1","to":[0,0]})"));
  hand.await_begun(1);
  auto fills_the_queue = desk.send(call(2, "drag.move", R"({"dragId":"d2","to":[6,5]})"));
  const std::string end = R"({"dragId":"d2","markerId":"m1"})";
  EXPECT_EQ(code_of(desk.ask_json(call(3, "drag.end", end))), -32010);
  hand.let_through();
  EXPECT_TRUE(Json::parse(fills_the_queue.get()).contains("result"));
  EXPECT_EQ(desk.ask_json(call(4, "drag.end", end))["result"]["placements"][0]["at"], Json::parse("[6,5]"));
}

TEST(Drags, AMarkerThatMovedOnRefusesTheEnd) {
  Desk desk;
  (void)desk.open_small();
  (void)desk.result("drag.begin", "{'markerId':'m1','piece':'low','baseRev':1}");
  (void)desk.result("drag.move", "{'dragId':'d1','to':[7,1]}");
  (void)desk.result("motion.compact", "{'markerId':'m1'}");
  EXPECT_EQ(code_of(desk.result("drag.end", "{'dragId':'d1','markerId':'m1'}")), -32801);
  EXPECT_EQ(code_of(desk.result("drag.begin", "{'markerId':'m1','piece':'low','baseRev':1}")), -32801);
}

TEST(Drags, BelongToTheirConnectionAndEndWithIt) {
  Desk desk;
  Listener other;
  (void)desk.open_small();
  (void)desk.ask(call(1, "drag.begin", R"({"markerId":"m1","piece":"low"})"), other.session());
  EXPECT_EQ(code_of(desk.result("drag.move", "{'dragId':'d1','to':[7,1]}")), -32602);
  EXPECT_EQ(desk.drags.count(), 1U);
  other.leave();
  for (std::size_t i = 0; i < server::methods::Drags::kMostPerSession; ++i) {
    EXPECT_TRUE(desk.result("drag.begin", "{'markerId':'m1','piece':'high'}").contains("dragId"));
  }
  EXPECT_EQ(desk.drags.count(), server::methods::Drags::kMostPerSession);  // the one that was left is gone
  EXPECT_EQ(code_of(desk.result("drag.begin", "{'markerId':'m1','piece':'high'}")), -32013);
}

}  // namespace
}  // namespace selvage::test
