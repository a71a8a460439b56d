#include "server/memory/byte_account.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <string>
#include <thread>
#include <vector>

namespace selvage::server::memory {
namespace {

TEST(ByteAccount, AddsNothingBeyondItsLimitUnlessItMust) {
  const auto account = std::make_shared<ByteAccount>(100);
  HeldBytes held{account, 60};
  EXPECT_TRUE(account->has_room(40));
  EXPECT_FALSE(account->has_room(41));
  EXPECT_FALSE(held.try_add(41));
  EXPECT_EQ(account->held(), 60U);
  EXPECT_TRUE(held.try_add(40));
  EXPECT_FALSE(account->has_room());
  held.add(50);  // not to be refused
  EXPECT_EQ(account->held(), 150U);
  held.set(0);
  EXPECT_EQ(account->held(), 0U);
}

TEST(ByteAccount, AnEighthIsReservedForThoseWhoHoldLittle) {
  const ByteAccount account{800};
  EXPECT_TRUE(account.has_room(account.beside_reserve(700)));
  EXPECT_FALSE(account.has_room(account.beside_reserve(701)));
  EXPECT_TRUE(account.has_room(701));
}

TEST(ByteAccount, AMovedNumberIsCountedOnce) {
  const auto account = std::make_shared<ByteAccount>(100);
  {
    HeldBytes first{account, 30};
    const HeldBytes second{std::move(first)};
    EXPECT_EQ(account->held(), 30U);
  }
  EXPECT_EQ(account->held(), 0U);
}

TEST(ByteAccount, SeveralThreadsTogetherDoNotExceedTheLimit) {
  const auto account = std::make_shared<ByteAccount>(1000);
  std::atomic<int> taken{};
  std::latch tried{4};
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < 4; ++k) {
      threads.emplace_back([&] {
        HeldBytes held{account};
        for (int i = 0; i < 1000; ++i) {
          if (held.try_add(3)) ++taken;
        }
        tried.arrive_and_wait();  // nobody gives anything back before
      });
    }
  }
  EXPECT_EQ(taken, 333);
  EXPECT_EQ(account->held(), 0U);
}

TEST(Weighed, AValueIsCountedAsLongAsAnybodyHoldsIt) {
  const auto account = std::make_shared<ByteAccount>();
  auto first = weighed(std::string{"text"}, HeldBytes{account, 7});
  auto second = first;
  first.reset();
  EXPECT_EQ(*second, "text");
  EXPECT_EQ(account->held(), 7U);
  second.reset();
  EXPECT_EQ(account->held(), 0U);
}

}  // namespace
}  // namespace selvage::server::memory
