#include "server/ops/throttle.h"

#include <gtest/gtest.h>

namespace selvage::server::ops {
namespace {

using namespace std::chrono_literals;

TEST(Throttle, PassesOncePerIntervalAndCountsTheRest) {
  Throttle throttle{1s};
  const Throttle::Time start{100s};
  EXPECT_EQ(throttle.pass(start), 0U);
  EXPECT_EQ(throttle.pass(start), std::nullopt);
  EXPECT_EQ(throttle.pass(start + 999ms), std::nullopt);
  EXPECT_EQ(throttle.pass(start + 1s), 2U);
  EXPECT_EQ(throttle.pass(start + 1500ms), std::nullopt);
  EXPECT_EQ(throttle.pass(start + 1h), 1U);
  EXPECT_EQ(throttle.pass(start + 2h), 0U);
}

}  // namespace
}  // namespace selvage::server::ops
