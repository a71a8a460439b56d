// Deadlines on the clock's own thread.
#include "server/jobs/deadline_clock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>

#include "tests/server/wire/wire.h"

namespace selvage::test {
namespace {

TEST(DeadlineClock, CallsEachInOrderAndSkipsRemovedOnes) {
  using namespace std::chrono_literals;
  server::jobs::DeadlineClock clock;
  const auto now = std::chrono::steady_clock::now();
  std::promise<void> first;
  std::promise<void> last;
  const auto far = clock.at(now + 1h, [] { ADD_FAILURE() << "an hour has not passed"; });
  (void)clock.at(now + 1ms, [] {});  // removed immediately
  const auto late = clock.at(now + 40ms, [&] { last.set_value(); });
  const auto soon = clock.at(now + 10ms, [&] { first.set_value(); });
  ASSERT_EQ(first.get_future().wait_for(kPatience), std::future_status::ready);
  ASSERT_EQ(last.get_future().wait_for(kPatience), std::future_status::ready);
}

}  // namespace
}  // namespace selvage::test
