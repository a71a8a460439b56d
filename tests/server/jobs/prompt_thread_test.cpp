// Which threads get a processor as soon as they wake up, as the kernel says.
#include "server/jobs/prompt_thread.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <fstream>
#include <functional>
#include <future>
#include <latch>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include "server/jobs/deadline_clock.h"
#include "server/jobs/job_queue.h"
#include "server/jobs/lateness.h"
#include "server/jobs/real_time_share.h"
#include "server/jobs/scheduling.h"
#include "tests/support/crowd.h"

namespace selvage::server::jobs {
namespace {

using std::chrono::nanoseconds;
using std::chrono::steady_clock;

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

class InRealTime : public testing::Test {
 protected:
  void SetUp() override {
    if (!use_real_time(RealTime::kAlways)) GTEST_SKIP() << "this system allows no real-time priorities";
  }
  void TearDown() override { (void)use_real_time(RealTime::kNever); }
};

TEST_F(InRealTime, ThreadsThatAllWaitForComeFirst) {
  EXPECT_GT(priority_of(Promptness::kFirst), priority_of(Promptness::kSoon));
  EXPECT_GT(priority_of(Promptness::kSoon), priority_of(Promptness::kNext));
  EXPECT_GT(priority_of(Promptness::kNext), 0U);
  EXPECT_EQ(real_time_priority(), 0U);
}

TEST_F(InRealTime, ThreadsThatTheyStartHaveNone) {
  unsigned started = 1;
  std::jthread{[&] {
    run_promptly(Promptness::kFirst);
    std::jthread{[&] { started = real_time_priority(); }}.join();
  }}.join();
  EXPECT_EQ(started, 0U);
}

TEST_F(InRealTime, WorkersForLongJobsHaveNone) {
  const auto [long_jobs, quick_jobs] = on_workers([] { return real_time_priority(); });
  EXPECT_EQ(long_jobs, 0U);
  EXPECT_GT(quick_jobs, 0U);
}

// Works until the calling thread's priority is (not) one of real time.  Returns false after far too long.
bool work_until_real_time_is(bool wanted) {
  const auto patience = steady_clock::now() + std::chrono::seconds{60};
  while (steady_clock::now() < patience) {
    if ((real_time_priority() > 0) == wanted) return true;
  }
  return false;
}

TEST_F(InRealTime, AThreadThatDoesNotEndItsWorkIsAnOrdinaryOneForTheRestOfEachPeriod) {
  for (const Promptness how : {Promptness::kFirst, Promptness::kSoon, Promptness::kNext}) {
    ASSERT_TRUE(use_real_time(RealTime::kNever));
    const nanoseconds slice = slice_of(how);
    ASSERT_TRUE(use_real_time(RealTime::kAlways));
    std::jthread{[how, slice] {
      const int nice = ::getpriority(PRIO_PROCESS, 0);
      run_promptly(how);
      const unsigned priority = real_time_priority();
      for (int periods = 0; periods < 3; ++periods) {
        ASSERT_TRUE(work_until_real_time_is(false));
        EXPECT_EQ(time_slice(), slice);
        EXPECT_EQ(::getpriority(PRIO_PROCESS, 0), nice);
        ASSERT_TRUE(work_until_real_time_is(true));
        EXPECT_EQ(real_time_priority(), priority);
      }
    }}.join();
  }
}

// The calling thread's processor time.
nanoseconds worked() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds{time.tv_sec} + nanoseconds{time.tv_nsec};
}

// However long it works, a thread that waits for nothing has the priority for its share of the time, and the ticks by
// which the kernel may be late.
TEST_F(InRealTime, TheShareHolds) {
  std::jthread{[] {
    run_promptly(Promptness::kNext);
    ASSERT_TRUE(work_until_real_time_is(false));
    ASSERT_TRUE(work_until_real_time_is(true));  // a period begins
    const auto end = steady_clock::now() + 5 * RealTimeShare::kPeriod;
    nanoseconds in_real_time{};
    for (nanoseconds last = worked(); steady_clock::now() < end;) {
      const bool real_time = real_time_priority() > 0;
      const nanoseconds now = worked();
      if (real_time) in_real_time += now - last;
      last = now;
    }
    EXPECT_GT(in_real_time, nanoseconds{});
    constexpr std::chrono::milliseconds kShare{10};
    constexpr std::chrono::milliseconds kTick{10};
    EXPECT_LT(in_real_time, 6 * (kShare + kTick));
  }}.join();
}

TEST_F(InRealTime, AThreadThatGivesItUpDoesNotGetItBack) {
  std::jthread{[] {
    run_promptly(Promptness::kNext);
    ASSERT_TRUE(work_until_real_time_is(false));
    ASSERT_TRUE(use_real_time(RealTime::kNever));
    run_promptly(Promptness::kNext);
    const auto end = steady_clock::now() + 2 * RealTimeShare::kPeriod;
    while (steady_clock::now() < end) ASSERT_EQ(real_time_priority(), 0U);
  }}.join();
}

// Without working for its share of the time.
void wake_up_in_time_until_ordinary() {
  do {
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
    woke_up_after({});
  } while (real_time_priority() > 0);
}

// On a thread that is not a prompt one.
void be_late_elsewhere(int times, bool (*are_short)() = processors_are_short) {
  std::jthread{[times, are_short] {
    for (int i = 0; i < times; ++i) woke_up_after(Lateness::kLate, are_short);
  }}.join();
}

TEST_F(InRealTime, OnlyWhileThreadsWaitForProcessorsIfSoWished) {
  ASSERT_TRUE(use_real_time(RealTime::kWhenLate));
  const test::Crowd crowd;
  ASSERT_TRUE(processors_are_short());
  std::jthread{[] {
    run_promptly(Promptness::kSoon);
    wake_up_in_time_until_ordinary();  // some other test may have been late
    for (int i = 0; i < 2; ++i) woke_up_after(Lateness::kLate / 2);
    EXPECT_EQ(real_time_priority(), 0U);
    const auto late = steady_clock::now();
    be_late_elsewhere(2);
    EXPECT_EQ(real_time_priority(), 0U);
    woke_up_after({});
    EXPECT_GT(real_time_priority(), 0U);
    wake_up_in_time_until_ordinary();
    EXPECT_GE(steady_clock::now() - late, Lateness::kLately);
  }}.join();
}

TEST_F(InRealTime, NotWhenThreadsAreLateWithProcessorsToSpare) {
  ASSERT_TRUE(use_real_time(RealTime::kWhenLate));
  std::jthread{[] {
    run_promptly(Promptness::kSoon);
    wake_up_in_time_until_ordinary();
    be_late_elsewhere(2, [] { return false; });
    woke_up_after({});
    EXPECT_EQ(real_time_priority(), 0U);
    be_late_elsewhere(2, [] { return true; });
    woke_up_after({});
    EXPECT_GT(real_time_priority(), 0U);
  }}.join();
}

TEST(ProcessorsAreShort, WhenMoreThreadsCouldRunThanThereAreProcessors) {
  const auto with_two = [](const char* load) {
    std::istringstream text{load};
    return processors_are_short(text, 2);
  };
  EXPECT_FALSE(with_two("0.20 9.18 9.12 1/1024 27365\n"));
  EXPECT_FALSE(with_two("5.20 9.18 9.12 2/1024 27365\n"));
  EXPECT_TRUE(with_two("0.20 0.18 0.12 3/1024 27365\n"));
  EXPECT_TRUE(with_two("")) << "where the kernel does not say, they might";
}

TEST_F(InRealTime, TheClockAlways) {
  ASSERT_TRUE(use_real_time(RealTime::kWhenLate));
  std::promise<unsigned> on_time;
  DeadlineClock clock;
  const auto alarm = clock.at(clock.now(), [&] { on_time.set_value(real_time_priority()); });
  EXPECT_EQ(on_time.get_future().get(), priority_of(Promptness::kAlarm));
}

TEST_F(InRealTime, AlwaysIfSoWished) {
  std::jthread{[] {
    run_promptly(Promptness::kSoon);
    woke_up_after({});
    EXPECT_GT(real_time_priority(), 0U);
  }}.join();
}

TEST_F(InRealTime, AThreadThatIsNotAPromptOneHasNoneWhenItIsLate) {
  ASSERT_TRUE(use_real_time(RealTime::kWhenLate));
  const test::Crowd crowd;
  std::jthread{[] {
    for (int i = 0; i < 2; ++i) woke_up_after(Lateness::kLate);
    EXPECT_EQ(real_time_priority(), 0U);
  }}.join();
}

TEST_F(InRealTime, AWorkerForQuickJobsThatTakesAJobLateIsOneThatWokeUpLate) {
  ASSERT_TRUE(use_real_time(RealTime::kWhenLate));
  const test::Crowd crowd;
  std::atomic<int> asked{};
  std::atomic<unsigned> priority{};
  JobQueue queue{1, 8, {1}, [&asked] { return steady_clock::time_point{Lateness::kLate * ++asked}; }};
  const auto patience = steady_clock::now() + std::chrono::seconds{60};
  // A job wakes that worker if it waits for one.
  while (priority == 0 && steady_clock::now() < patience) {
    std::latch done{1};
    submit(queue, true, [&] {
      priority = real_time_priority();
      done.count_down();
    });
    done.wait();
  }
  EXPECT_GT(priority, 0U);
}

TEST_F(InRealTime, AThreadThatEndsLeavesNoTimerBehind) {
  const auto timers = [] {
    std::ifstream file{"/proc/self/timers"};
    int found = 0;
    for (std::string line; std::getline(file, line);) found += line.starts_with("ID:") ? 1 : 0;
    return found;
  };
  const int before = timers();
  bool counted = false;
  std::jthread{[&] {
    run_promptly(Promptness::kNext);
    counted = timers() > before;
  }}.join();
  if (!counted) GTEST_SKIP() << "this kernel does not tell which timers there are";
  EXPECT_EQ(timers(), before);
}

}  // namespace
}  // namespace selvage::server::jobs
