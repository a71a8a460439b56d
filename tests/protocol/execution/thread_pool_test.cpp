// Every race is staged with latches; nothing sleeps.
#include "protocol/execution/thread_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <set>
#include <stdexcept>
#include <string>

namespace selvage::protocol::execution {
namespace {

TEST(ThreadPool, DoesEveryPartOnce) {
  for (const std::size_t helpers : {0U, 1U, 3U, 6U}) {
    const ThreadPool executor{helpers};
    EXPECT_EQ(executor.parallelism(), helpers + 1);
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
      std::vector<std::atomic<int>> done(count);
      executor.for_each(count, [&](std::size_t k) { ++done[k]; });
      for (const auto& times : done) EXPECT_EQ(times, 1);
    }
  }
}

TEST(ThreadPool, DoesPartsAtTheSameTime) {
  const ThreadPool executor{2};
  std::latch all{3};
  executor.for_each(3, [&](std::size_t) { all.arrive_and_wait(); });  // ends only when three parts run at the same time
}

TEST(ThreadPool, WithoutPoolThreadsTheCallerDoesEverything) {
  const ThreadPool executor{0};
  std::set<std::thread::id> threads;
  executor.for_each(20, [&](std::size_t) { threads.insert(std::this_thread::get_id()); });
  EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

TEST(ThreadPool, PoolThreadsTakeNothingWhileNoCoreIsFree) {
  const ThreadPool executor{3, [] { return std::size_t{0}; }};
  EXPECT_EQ(executor.parallelism(), 1U);
  std::set<std::thread::id> threads;  // needs no lock, because one thread does everything
  executor.for_each(500, [&](std::size_t) { threads.insert(std::this_thread::get_id()); });
  EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

TEST(ThreadPool, NoMorePoolThreadsWorkThanCoresAreFree) {
  const ThreadPool executor{5, [] { return std::size_t{2}; }};
  EXPECT_EQ(executor.parallelism(), 3U);
  std::atomic<int> now{};
  std::atomic<int> most{};
  executor.for_each(3000, [&](std::size_t) {
    const int mine = ++now;
    for (int seen = most; seen < mine && !most.compare_exchange_weak(seen, mine);) {
    }
    --now;
  });
  EXPECT_LE(most, 3);
}

TEST(ThreadPool, AsksForACoreBeforeEveryPart) {
  std::atomic<std::size_t> spare{1};
  const ThreadPool executor{1, [&] { return spare.load(); }};
  const auto caller = std::this_thread::get_id();
  std::latch helped{1};
  std::atomic<int> by_helper{};
  executor.for_each(100, [&](std::size_t k) {
    if (std::this_thread::get_id() != caller) {
      spare = 0;  // from now on no core is free
      ++by_helper;
      helped.count_down();
    } else if (k == 0) {
      helped.wait();
    }
  });
  EXPECT_EQ(by_helper, 1);
  EXPECT_EQ(executor.parallelism(), 1U);
}

std::string thrown_by(const Executor& executor, std::size_t count, const Executor::Part& part) {
  try {
    executor.for_each(count, part);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(ThreadPool, RethrowsTheExceptionOfTheFirstFailedPart) {
  const ThreadPool executor{1};
  for (int trial = 0; trial < 100; ++trial) {
    std::latch both{2};
    const std::string thrown = thrown_by(executor, 2, [&](std::size_t k) {
      both.arrive_and_wait();
      throw std::runtime_error{std::to_string(k)};
    });
    ASSERT_EQ(thrown, "0");
  }
}

TEST(ThreadPool, StartsNoPartAfterOneHasFailed) {
  const ThreadPool executor{0};
  int begun = 0;
  const std::string thrown = thrown_by(executor, 50, [&](std::size_t k) {
    ++begun;
    if (k == 7) throw std::runtime_error{"7"};
  });
  EXPECT_EQ(thrown, "7");
  EXPECT_EQ(begun, 8);
}

TEST(ThreadPool, WaitsForRunningPartsWhenOneFailsAndRemainsUsable) {
  const ThreadPool executor{1};
  std::latch both{2};
  std::atomic<bool> ended{};
  const std::string thrown = thrown_by(executor, 2, [&](std::size_t k) {
    both.arrive_and_wait();
    if (k == 0) throw std::runtime_error{"0"};
    for (int turn = 0; turn < 1000; ++turn) std::this_thread::yield();
    ended = true;
  });
  EXPECT_EQ(thrown, "0");
  EXPECT_TRUE(ended);
  std::atomic<int> done{};
  executor.for_each(50, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 50);
}

TEST(ThreadPool, ServesSeveralCallersAtOnce) {
  const ThreadPool executor{2};
  std::latch together{3};
  std::vector<int> sums(3);
  {
    std::vector<std::jthread> callers;
    for (std::size_t caller = 0; caller < 3; ++caller) {
      callers.emplace_back([&, caller] {
        together.arrive_and_wait();
        std::vector<int> found(400);
        executor.for_each(found.size(), [&](std::size_t k) { found[k] = static_cast<int>(k); });
        for (const int value : found) sums[caller] += value;
      });
    }
  }
  EXPECT_EQ(sums, (std::vector<int>(3, 400 * 399 / 2)));
}

TEST(ThreadPool, APartMayHavePartsOfItsOwn) {
  const ThreadPool executor{2};
  std::atomic<int> done{};
  executor.for_each(5, [&](std::size_t) { executor.for_each(7, [&](std::size_t) { ++done; }); });
  EXPECT_EQ(done, 35);
}

}  // namespace
}  // namespace selvage::protocol::execution
