// The clock is staged.
#include "server/jobs/lateness.h"

#include <gtest/gtest.h>

#include <chrono>

namespace selvage::server::jobs {
namespace {

using namespace std::chrono_literals;
using Time = Lateness::Clock::time_point;

constexpr Time kStart{1h};

TEST(Lateness, NobodyHasBeenLateAtFirst) {
  const Lateness lateness;
  EXPECT_FALSE(lateness.lately(kStart));
  EXPECT_FALSE(lateness.lately(Time{}));
}

TEST(Lateness, LastsForThreeSeconds) {
  Lateness lateness;
  lateness.record(500us, kStart);
  EXPECT_TRUE(lateness.lately(kStart));
  EXPECT_TRUE(lateness.lately(kStart + 2999ms));
  EXPECT_FALSE(lateness.lately(kStart + 3s));
}

TEST(Lateness, ThreadsThatWakeUpSoonerNeitherBeginNorEndIt) {
  Lateness lateness;
  lateness.record(499us, kStart);
  EXPECT_FALSE(lateness.lately(kStart));
  lateness.record(4ms, kStart);
  lateness.record(10us, kStart + 500ms);
  EXPECT_TRUE(lateness.lately(kStart + 2999ms));
  EXPECT_FALSE(lateness.lately(kStart + 3s));
}

TEST(Lateness, EndsAfterAThousandPunctualWakeUps) {
  Lateness lateness;
  lateness.record(1ms, kStart);
  for (int i = 0; i < 999; ++i) lateness.record(0ms, kStart);
  EXPECT_TRUE(lateness.lately(kStart));
  lateness.record(0ms, kStart);
  EXPECT_FALSE(lateness.lately(kStart));
  lateness.record(1ms, kStart);
  EXPECT_TRUE(lateness.lately(kStart));
}

TEST(Lateness, TheLastTimeCounts) {
  Lateness lateness;
  lateness.record(1ms, kStart);
  lateness.record(1ms, kStart + 900ms);
  EXPECT_TRUE(lateness.lately(kStart + 3899ms));
  EXPECT_FALSE(lateness.lately(kStart + 3900ms));
}

}  // namespace
}  // namespace selvage::server::jobs
