// Sessions, markers and quick calls do not wait for each other's motions.
#include <gtest/gtest.h>

#include <future>
#include <mutex>
#include <string>
#include <vector>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

TEST(Fairness, AnEditDoesNotWaitForMotionsOfOtherMarkers) {
  Gate gate;
  LocalServer local{2, gate.methods()};
  for (int i = 0; i < 4; ++i) (void)local.open_small();
  std::vector<std::future<std::string>> solves;
  for (const char* marker : {"m1", "m2", "m3"}) {  // one more than there are workers
    solves.push_back(local.send(call(1, "motion.compact", std::string{R"({"markerId":")"} + marker + R"("})")));
  }
  gate.await_arrivals(2);
  const Json edited = local.result("marker.apply", "{'markerId':'m4','ops':[{'op':'move','piece':'low','at':[5,0]}]}");
  EXPECT_EQ(edited["revision"], 2);
  EXPECT_EQ(local.result("marker.undo", "{'markerId':'m4'}")["revision"], 3);
  EXPECT_EQ(local.result("marker.redo", "{'markerId':'m4'}")["revision"], 4);
  EXPECT_EQ(local.result("motion.bump", "{'markerId':'m4','piece':'low','direction':[-1,0]}")["revision"], 5);
  EXPECT_EQ(local.result("motion.place", "{'markerId':'m4','piece':'low','to':[6,0]}")["revision"], 6);
  // An edit of a marker whose motion is running waits: one change at a time.
  auto behind = local.send(call(2, "marker.apply", R"({"markerId":"m1","ops":[{"op":"lock","piece":"low"}]})"));
  EXPECT_EQ(gate.arrived(), 2);
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
  gate.open();
  EXPECT_EQ(Json::parse(behind.get())["result"]["revision"], 3);
  for (auto& solve : solves) EXPECT_EQ(Json::parse(solve.get())["result"]["revision"], 2);
}

TEST(Fairness, ASessionThatFillsTheQueueBlocksNoOther) {
  Gate gate;
  server::calls::Limits limits;
  limits.waiting_motions = 2;
  LocalServer local{1, gate.methods(), limits};
  Client other;
  (void)local.open_small();
  std::vector<std::future<std::string>> calls;
  for (int i = 0; i < 4; ++i) {
    calls.push_back(local.send(call(i, "motion.compact", R"({"markerId":"m1"})")));
    if (i == 0) gate.await_arrivals(1);
  }
  EXPECT_EQ(code_of(Json::parse(calls.back().get())), -32010);
  auto others =
      local.send(call(9, "motion.bump", R"({"markerId":"m1","piece":"low","direction":[1,0]})"), other.session());
  gate.open();
  EXPECT_TRUE(Json::parse(others.get()).contains("result"));
}

TEST(Fairness, ASessionWithManyMotionsDelaysAnotherByOne) {
  Gate gate;
  LocalServer local{1, gate.methods()};
  Client other;
  std::mutex mutex;
  std::vector<int> order;  // of the answers
  constexpr int kMany = 20, kOther = 100;
  const auto compact = [&](int number, const std::shared_ptr<server::transport::access::Session>& session) {
    local.backend.receive(call(number, "motion.compact", R"({"markerId":")" + local.open_small() + R"("})"), session,
                          [&](const std::string& answer) {
                            const std::lock_guard lock{mutex};
                            order.push_back(Json::parse(answer)["id"].get<int>());
                          });
  };
  compact(0, local.client.session());
  gate.await_arrivals(1);
  for (int i = 1; i < kMany; ++i) compact(i, local.client.session());
  compact(kOther, other.session());
  gate.open();
  local.backend.queues().motions.drain();
  ASSERT_EQ(order.size(), std::size_t{kMany + 1});
  EXPECT_EQ(std::vector<int>(order.begin(), order.begin() + 4), (std::vector{0, 1, kOther, 2}));
}

}  // namespace
}  // namespace selvage::test
