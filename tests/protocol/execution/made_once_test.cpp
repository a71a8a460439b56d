#include "protocol/execution/made_once.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace selvage::protocol::execution {
namespace {

TEST(MadeOnce, IsMadeByTheFirstAndSharedByAll) {
  const MadeOnce<int> once;
  std::atomic<int> made{};
  std::vector<std::shared_ptr<const int>> got(8);
  {
    std::vector<std::jthread> threads;
    for (auto& mine : got) threads.emplace_back([&] { mine = once.get([&] { return ++made; }); });
  }
  EXPECT_EQ(made, 1);
  for (const auto& value : got) EXPECT_EQ(value, got.front());
}

TEST(MadeOnce, IsMadeByTheNextWhenMakingFailed) {
  const MadeOnce<int> once;
  EXPECT_THROW((void)once.get([]() -> int { throw std::runtime_error{"no"}; }), std::runtime_error);
  EXPECT_EQ(*once.get([] { return 7; }), 7);
}

}  // namespace
}  // namespace selvage::protocol::execution
