// The order in which sessions are served.
#include "server/jobs/fair_queue.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace selvage::test {
namespace {

TEST(FairQueue, ServesSessionsRoundRobinAndEachInOrder) {
  server::jobs::FairQueue<std::string> line;
  for (const char* thing : {"a1", "a2", "a3", "a4"}) line.push(1, thing);
  line.push(2, "b1");
  line.push(2, "b2");
  line.push(3, "c1");
  std::string order;
  const auto any = [](const std::string&) { return true; };
  while (const auto next = line.take(any)) order += *next + " ";
  EXPECT_EQ(order, "a1 b1 c1 a2 b2 a3 a4 ");
  EXPECT_TRUE(line.empty());
}

TEST(FairQueue, ServesManySessionsRoundRobinForLong) {
  constexpr int kSessions = 100, kThings = 50;
  server::jobs::FairQueue<int> line;
  for (int thing = 0; thing < kThings; ++thing) {
    for (std::uint64_t session = 0; session < kSessions; ++session) line.push(session, thing);
  }
  const auto any = [](int) { return true; };
  for (int thing = 0; thing < kThings; ++thing) {
    for (int turn = 0; turn < kSessions; ++turn) ASSERT_EQ(line.take(any), thing);
  }
  EXPECT_TRUE(line.empty());
}

TEST(FairQueue, TakesTheFirstAcceptableElementAndLeavesTheOthers) {
  server::jobs::FairQueue<std::string> line;
  for (const char* thing : {"a1", "a2!", "a3!"}) line.push(1, thing);
  line.push(2, "b1");
  line.push(3, "c1!");
  const auto marked = [](const std::string& thing) { return thing.back() == '!'; };
  std::string order;
  while (const auto next = line.take(marked)) order += *next + " ";
  EXPECT_EQ(order, "a2! c1! a3! ");
  EXPECT_EQ(line.size(), 2U);
}

}  // namespace
}  // namespace selvage::test
