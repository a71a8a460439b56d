// Which threads get a processor as soon as they wake up, as the kernel says.
#include "server/jobs/prompt_thread.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <future>
#include <latch>
#include <thread>
#include <utility>

#include "server/jobs/deadline_clock.h"
#include "server/jobs/job_queue.h"

namespace selvage::server::jobs {
namespace {

using std::chrono::nanoseconds;

nanoseconds slice_of(Promptness how) {
  nanoseconds slice{};
  std::jthread{[&slice, how] {
    run_promptly(how);
    slice = time_slice();
  }}.join();
  return slice;
}

class PromptThread : public testing::Test {
 protected:
  void SetUp() override {
    if (time_slice() == nanoseconds{}) GTEST_SKIP() << "this kernel's time slices have one length";
  }
};

TEST_F(PromptThread, HasShorterSlicesThanOthers) {
  EXPECT_LT(slice_of(Promptness::kFirst), slice_of(Promptness::kSoon));
  EXPECT_LT(slice_of(Promptness::kSoon), slice_of(Promptness::kNext));
  EXPECT_LT(slice_of(Promptness::kNext), time_slice());
}

TEST_F(PromptThread, KeepsItsPriority) {
  constexpr int kLowered = 3;
  int nice = 0;
  std::jthread{[&nice] {
    (void)::nice(kLowered);
    run_promptly(Promptness::kFirst);
    nice = ::getpriority(PRIO_PROCESS, 0);
  }}.join();
  EXPECT_EQ(nice, ::getpriority(PRIO_PROCESS, 0) + kLowered);
}

TEST_F(PromptThread, GivingWayLowersAThreadAndThoseThatItStarts) {
  const nanoseconds slice = time_slice();
  int own = 0;
  int started = 0;
  std::jthread{[&] {
    give_way();
    own = ::getpriority(PRIO_PROCESS, 0);
    std::jthread{[&] { started = ::getpriority(PRIO_PROCESS, 0); }}.join();
    EXPECT_EQ(time_slice(), slice);
  }}.join();
  EXPECT_GT(own, ::getpriority(PRIO_PROCESS, 0));
  EXPECT_EQ(started, own);
}

void submit(JobQueue& queue, bool quick, std::function<void()> work) {
  Job job{};
  job.quick = quick;
  job.work = Work{[held = std::move(work)](auto&&) { held(); }};
  EXPECT_EQ(queue.submit(job), Admission::kAccepted);
}

// What `measure` returns on a worker for all jobs, and on one for quick jobs only.
template <class Measure>
auto on_workers(const Measure& measure) {
  using Value = decltype(measure());
  std::promise<Value> of_long;
  std::promise<Value> of_quick;
  std::latch done{1};
  JobQueue queue{1, 8, {1}};
  submit(queue, false, [&] {
    of_long.set_value(measure());
    done.wait();
  });
  const Value long_jobs = of_long.get_future().get();
  submit(queue, true, [&] { of_quick.set_value(measure()); });  // while the other worker is busy
  const Value quick_jobs = of_quick.get_future().get();
  done.count_down();
  return std::pair{long_jobs, quick_jobs};
}

TEST_F(PromptThread, OnlyWorkersForQuickJobsAreSuchThreads) {
  const auto [long_jobs, quick_jobs] = on_workers([] { return time_slice(); });
  EXPECT_EQ(quick_jobs, slice_of(Promptness::kSoon));
  EXPECT_EQ(long_jobs, time_slice());
}

TEST_F(PromptThread, TheClockThatAnswersAtDeadlinesIsOne) {
  std::promise<nanoseconds> measured;
  DeadlineClock clock;
  const auto alarm = clock.at(clock.now(), [&] { measured.set_value(time_slice()); });
  EXPECT_EQ(measured.get_future().get(), slice_of(Promptness::kFirst));
}

unsigned priority_of(Promptness how) {
  unsigned priority = 0;
  std::jthread{[&priority, how] {
    run_promptly(how);
    priority = real_time_priority();
  }}.join();
  return priority;
}

TEST(WithoutRealTime, NoThreadHasSuchAPriority) {
  EXPECT_EQ(priority_of(Promptness::kFirst), 0U);
  EXPECT_EQ(priority_of(Promptness::kSoon), 0U);
  EXPECT_EQ(priority_of(Promptness::kNext), 0U);
}

class RealTime : public testing::Test {
 protected:
  void SetUp() override {
    if (!use_real_time(true)) GTEST_SKIP() << "this system allows no real-time priorities";
  }
  void TearDown() override { (void)use_real_time(false); }
};

TEST_F(RealTime, ThreadsThatAllWaitForComeFirst) {
  EXPECT_GT(priority_of(Promptness::kFirst), priority_of(Promptness::kSoon));
  EXPECT_GT(priority_of(Promptness::kSoon), priority_of(Promptness::kNext));
  EXPECT_GT(priority_of(Promptness::kNext), 0U);
  EXPECT_EQ(real_time_priority(), 0U);
}

TEST_F(RealTime, ThreadsThatTheyStartHaveNone) {
  unsigned started = 1;
  std::jthread{[&] {
    run_promptly(Promptness::kFirst);
    std::jthread{[&] { started = real_time_priority(); }}.join();
  }}.join();
  EXPECT_EQ(started, 0U);
}

TEST_F(RealTime, WorkersForLongJobsHaveNone) {
  const auto [long_jobs, quick_jobs] = on_workers([] { return real_time_priority(); });
  EXPECT_EQ(long_jobs, 0U);
  EXPECT_GT(quick_jobs, 0U);
}

}  // namespace
}  // namespace selvage::server::jobs
