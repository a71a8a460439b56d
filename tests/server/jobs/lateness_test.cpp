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
  for (const Time time : {Time{}, kStart}) {
    EXPECT_FALSE(lateness.lately(time));
    EXPECT_FALSE(lateness.often(time));
  }
}

TEST(Lateness, LastsForThreeSecondsFromTheLastTime) {
  Lateness lateness;
  lateness.record(true, kStart - 900ms);
  lateness.record(true, kStart);
  EXPECT_TRUE(lateness.lately(kStart + 2999ms));
  EXPECT_TRUE(lateness.often(kStart + 2999ms));
  EXPECT_FALSE(lateness.lately(kStart + 3s));
  EXPECT_FALSE(lateness.often(kStart + 3s));
}

void wake_up_in_time(Lateness& lateness, int times) {
  for (int i = 0; i < times; ++i) lateness.record(false, kStart);
}

TEST(Lateness, EndsAfterAThousandPunctualWakeUps) {
  Lateness lateness;
  for (int i = 0; i < 2; ++i) lateness.record(true, kStart);
  wake_up_in_time(lateness, 999);
  EXPECT_TRUE(lateness.lately(kStart));
  EXPECT_TRUE(lateness.often(kStart));
  wake_up_in_time(lateness, 1);
  EXPECT_FALSE(lateness.lately(kStart));
  EXPECT_FALSE(lateness.often(kStart));
}

TEST(Lateness, OnceIsNotOften) {
  Lateness lateness;
  lateness.record(true, kStart);
  EXPECT_TRUE(lateness.lately(kStart));
  EXPECT_FALSE(lateness.often(kStart));
}

TEST(Lateness, TwiceIsOftenWithFewWakeUpsBetween) {
  Lateness lateness;
  lateness.record(true, kStart);
  wake_up_in_time(lateness, 200);
  lateness.record(true, kStart);
  EXPECT_FALSE(lateness.often(kStart));
  wake_up_in_time(lateness, 199);
  lateness.record(true, kStart);
  EXPECT_TRUE(lateness.often(kStart));
}

TEST(Lateness, TwiceIsOftenWithinThreeSeconds) {
  Lateness lateness;
  lateness.record(true, kStart);
  lateness.record(true, kStart + 3s);
  EXPECT_FALSE(lateness.often(kStart + 3s));
  lateness.record(true, kStart + 5999ms);
  EXPECT_TRUE(lateness.often(kStart + 5999ms));
}

}  // namespace
}  // namespace selvage::server::jobs
