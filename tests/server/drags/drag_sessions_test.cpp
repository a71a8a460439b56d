// Drag sessions through the server.
#include <gtest/gtest.h>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

TEST(DragSessions, FollowThePointerAndCommitOnceAtTheEnd) {
  LocalServer local;
  (void)local.open_small();
  const Json begun = local.result("drag.begin", "{'markerId':'m1','piece':'low'}");
  EXPECT_EQ(begun["dragId"], "d1");
  EXPECT_EQ(begun["at"], Json::parse("[3,0]"));
  const Json free = local.result("drag.move", "{'dragId':'d1','to':[7,1]}");
  EXPECT_EQ(free["at"], Json::parse("[7,1]"));
  EXPECT_EQ(free["reached"], true);
  const Json blocked = local.result("drag.move", "{'dragId':'d1','to':[3,3]}");
  EXPECT_EQ(blocked["reached"], false);
  EXPECT_EQ(blocked["valid"], true);
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
  const Json ended = local.result("drag.end", "{'dragId':'d1','markerId':'m1','opId':'x'}");
  EXPECT_EQ(ended["revision"], 2);
  EXPECT_EQ(ended["placements"][0]["at"], blocked["at"]);
  EXPECT_EQ(local.result("drag.end", "{'dragId':'d1','markerId':'m1','opId':'x'}"), ended);
  EXPECT_EQ(local.result("drag.move", "{'dragId':'d1','to':[7,1]}")["error"]["data"]["field"], "/dragId");
}

TEST(DragSessions, PushOtherPiecesAside) {
  LocalServer local;
  (void)local.open_small();
  (void)local.result("drag.begin", "{'markerId':'m1','piece':'low','mode':'push'}");
  const Json moved = local.result("drag.move", "{'dragId':'d1','to':[3,3]}");
  EXPECT_EQ(moved["at"], Json::parse("[3,3]"));
  EXPECT_EQ(moved["pushed"], true);
  EXPECT_EQ(moved["valid"], true);
  EXPECT_EQ(moved["placements"].size(), 2U);
  const Json left = local.result("drag.end", "{'dragId':'d1','markerId':'m1','commit':false}");
  EXPECT_EQ(left["revision"], 1);
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
}

TEST(DragSessions, ALockedPieceStays) {
  LocalServer local;
  (void)local.open_small();
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'lock','piece':'low'}]}");
  (void)local.result("drag.begin", "{'markerId':'m1','piece':'low'}");
  EXPECT_EQ(local.result("drag.move", "{'dragId':'d1','to':[7,1]}")["at"], Json::parse("[3,0]"));
}

TEST(DragSessions, ATargetFarOutsideIsRefused) {
  LocalServer local;
  (void)local.open_small();
  (void)local.result("drag.begin", "{'markerId':'m1','piece':'low'}");
  for (const char* far : {"[1e12,0]", "[0,-1e12]"}) {
    const Json answer = local.result("drag.move", std::string{"{'dragId':'d1','to':"} + far + "}");
    EXPECT_EQ(code_of(answer), -32602) << far;
    EXPECT_EQ(answer["error"]["data"]["field"], "/to") << far;
  }
  EXPECT_EQ(local.result("drag.move", "{'dragId':'d1','to':[7,1]}")["reached"], true);
}

TEST(DragSessions, AnEndThatChangesNothingIsKeptForRetries) {
  LocalServer local;
  (void)local.open_small();
  for (const char* commit : {"true", "false"}) {
    const Json begun = local.result("drag.begin", "{'markerId':'m1','piece':'low'}");
    const std::string end = "{'dragId':'" + begun["dragId"].get<std::string>() + "','markerId':'m1','opId':'" + commit +
                            "','commit':" + commit + "}";
    if (std::string_view{commit} == "false") {
      (void)local.result("drag.move", "{'dragId':'" + begun["dragId"].get<std::string>() + "','to':[7,1]}");
    }
    const Json ended = local.result("drag.end", end);
    EXPECT_EQ(ended["revision"], 1);
    EXPECT_EQ(local.result("drag.end", end), ended) << commit;
  }
}

// Drag moves that wait until the test lets them through.
struct SlowDrag {
  [[nodiscard]] server::dispatch::BackendSettings settings(const server::calls::Limits& limits = {}) {
    server::dispatch::BackendSettings settings{.workers = 1, .limits = limits};
    settings.drag = [this](const Marker& start, const scene::LaidOut&, PieceId piece, Vec to,
                           motion::dragging::DragMode, const scene::Run&) {
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
    return settings;
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

TEST(DragSessions, TheLatestMoveIsExecutedAndSupersededOnesAreAnswered) {
  SlowDrag slow;
  LocalServer local{slow.settings()};
  (void)local.open_small();
  (void)local.result("drag.begin", "{'markerId':'m1','piece':'low'}");
  std::vector<std::future<std::string>> moves;
  moves.push_back(local.send(call(0, "drag.move", R"({"dragId":"d1","to":[0,0]})")));
  slow.await_begun(1);
  for (int i = 1; i < 50; ++i) {
    moves.push_back(local.send(call(i, "drag.move", R"({"dragId":"d1","to":[)" + std::to_string(i) + ",0]}")));
  }
  for (std::size_t i = 1; i < 49; ++i) EXPECT_EQ(code_of(Json::parse(moves[i].get())), -32802);
  auto end = local.send(call(50, "drag.end", R"({"dragId":"d1","markerId":"m1"})"));
  slow.let_through();
  EXPECT_EQ(Json::parse(moves[0].get())["result"]["at"], Json::parse("[0,0]"));
  EXPECT_EQ(Json::parse(moves[49].get())["result"]["at"], Json::parse("[49,0]"));
  const Json ended = Json::parse(end.get());
  EXPECT_EQ(ended["result"]["placements"][0]["at"], Json::parse("[49,0]"));
  EXPECT_EQ(slow.begun, 2);
}

TEST(DragSessions, AnEndThatIsRefusedAsBusyCanBeSentAgain) {
  SlowDrag slow;
  server::calls::Limits limits;
  limits.waiting_moves = 1;
  LocalServer local{slow.settings(limits)};
  (void)local.open_small();
  for (const char* piece : {"low", "low", "high"}) {  // one drag more than there are workers for drags
    (void)local.result("drag.begin", std::string{"{'markerId':'m1','piece':'"} + piece + "'}");
  }
  auto first = local.send(call(1, "drag.move", R"({"dragId":"d1","to":[0,0]})"));
  slow.await_begun(1);
  auto second = local.send(call(2, "drag.move", R"({"dragId":"d2","to":[0,0]})"));
  slow.await_begun(2);  // both workers are busy
  auto fills_the_queue = local.send(call(3, "drag.move", R"({"dragId":"d3","to":[6,5]})"));
  const std::string end = R"({"dragId":"d3","markerId":"m1"})";
  EXPECT_EQ(code_of(local.ask_json(call(4, "drag.end", end))), -32010);
  slow.let_through();
  EXPECT_TRUE(Json::parse(fills_the_queue.get()).contains("result"));
  EXPECT_EQ(local.ask_json(call(5, "drag.end", end))["result"]["placements"][0]["at"], Json::parse("[6,5]"));
}

TEST(DragSessions, TheEndIsRefusedIfTheMarkerHasChanged) {
  LocalServer local;
  (void)local.open_small();
  (void)local.result("drag.begin", "{'markerId':'m1','piece':'low','baseRev':1}");
  (void)local.result("drag.move", "{'dragId':'d1','to':[7,1]}");
  (void)local.result("motion.compact", "{'markerId':'m1'}");
  EXPECT_EQ(code_of(local.result("drag.end", "{'dragId':'d1','markerId':'m1'}")), -32801);
  EXPECT_EQ(code_of(local.result("drag.begin", "{'markerId':'m1','piece':'low','baseRev':1}")), -32801);
}

TEST(DragSessions, BelongToTheirConnectionAndEndWithIt) {
  LocalServer local;
  Client other;
  (void)local.open_small();
  (void)local.ask(call(1, "drag.begin", R"({"markerId":"m1","piece":"low"})"), other.session());
  EXPECT_EQ(code_of(local.result("drag.move", "{'dragId':'d1','to':[7,1]}")), -32602);
  EXPECT_EQ(local.backend.drags().count(), 1U);
  other.disconnect();
  for (std::size_t i = 0; i < server::drags::DragSessions::kMaxPerConnection; ++i) {
    EXPECT_TRUE(local.result("drag.begin", "{'markerId':'m1','piece':'high'}").contains("dragId"));
  }
  EXPECT_EQ(local.backend.drags().count(),
            server::drags::DragSessions::kMaxPerConnection);  // that of the disconnected client is removed
  EXPECT_EQ(code_of(local.result("drag.begin", "{'markerId':'m1','piece':'high'}")), -32013);
}

// What a notification reports about the pieces that others drag:  "piece x y" for each.
std::vector<std::string> told_of_drags(Client& client) {
  const Json message = client.next();
  EXPECT_EQ(message["method"], "marker.dragged");
  EXPECT_EQ(message["params"]["markerId"], "m1");
  std::vector<std::string> drags;
  for (const Json& drag : message["params"]["pieces"]) {
    drags.push_back(drag["piece"].get<std::string>() + " " + std::to_string(drag["at"][0].get<int>()) + " " +
                    std::to_string(drag["at"][1].get<int>()));
  }
  return drags;
}
using Told = std::vector<std::string>;

TEST(DragSessions, AreReportedToOtherWatchers) {
  LocalServer local;
  Client other;
  (void)local.open_small();
  (void)local.result("marker.watch", "{'markerId':'m1'}");
  (void)local.ask(call(1, "marker.watch", R"({"markerId":"m1"})"), other.session());
  (void)local.result("drag.begin", "{'markerId':'m1','piece':'low'}");
  EXPECT_EQ(told_of_drags(other), Told{"low 3 0"});
  (void)local.result("drag.move", "{'dragId':'d1','to':[7,1]}");
  EXPECT_EQ(told_of_drags(other), Told{"low 7 1"});
  // Each is notified of the other's drag only.
  (void)local.ask(call(2, "drag.begin", R"({"markerId":"m1","piece":"high"})"), other.session());
  EXPECT_EQ(told_of_drags(local.client).size(), 1U);
  (void)local.result("drag.end", "{'dragId':'d1','markerId':'m1','commit':false}");
  EXPECT_EQ(told_of_drags(other), Told{});
  (void)local.ask(call(3, "drag.end", R"({"dragId":"d2","markerId":"m1"})"), other.session());
  EXPECT_EQ(told_of_drags(local.client), Told{});
  EXPECT_EQ(local.client.pending(), 0U);
  EXPECT_EQ(other.pending(), 0U);
}

TEST(DragSessions, AreReportedToNewWatchersAndEndWithTheirConnection) {
  LocalServer local;
  Client hand;
  (void)local.open_small();
  (void)local.ask(call(1, "drag.begin", R"({"markerId":"m1","piece":"low"})"), hand.session());
  (void)local.result("marker.watch", "{'markerId':'m1'}");
  EXPECT_EQ(told_of_drags(local.client), Told{"low 3 0"});
  hand.disconnect();
  EXPECT_EQ(told_of_drags(local.client), Told{});
  EXPECT_EQ(local.backend.drags().count(), 0U);
  (void)local.result("marker.watch", "{'markerId':'m1'}");
  EXPECT_EQ(local.client.pending(), 0U);
}

// Freeing them may take long if they hold the last references to their revisions.
TEST(DragSessions, OfAConnectionThatEndsAreFreedByAWorker) {
  constexpr const char* kBegin = R"({"markerId":"m1","piece":"low"})";
  SlowDrag slow;
  LocalServer local{slow.settings()};
  Client client;
  (void)local.open_small();
  std::vector<std::future<std::string>> moves;
  for (const char* drag : {"d1", "d2"}) {
    (void)local.ask(call(1, "drag.begin", kBegin));
    moves.push_back(local.send(call(2, "drag.move", std::string{R"({"dragId":")"} + drag + R"(","to":[1,0]})")));
  }
  slow.await_begun(2);  // now no worker is free
  const auto account = local.store().room().account;
  const std::size_t before = account->held();
  (void)local.ask(call(1, "drag.begin", kBegin), client.session());
  const std::size_t held = account->held();
  EXPECT_GT(held, before);
  client.disconnect();
  EXPECT_EQ(local.backend.drags().count(), 2U);
  EXPECT_EQ(account->held(), held);
  slow.let_through();
  for (auto& sent : moves) EXPECT_TRUE(Json::parse(sent.get()).contains("result"));
  local.backend.queues().drags.drain();
  EXPECT_EQ(account->held(), before);
}

TEST(DragSessions, EndAtOnceWithTheirConnection) {
  LocalServer local;
  Client gone;
  (void)local.open_small();
  gone.disconnect();
  (void)local.ask(call(1, "drag.begin", R"({"markerId":"m1","piece":"low"})"), gone.session());
  EXPECT_EQ(local.backend.drags().count(), 0U);
}

}  // namespace
}  // namespace selvage::test
