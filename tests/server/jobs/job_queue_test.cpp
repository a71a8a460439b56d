// Every race is staged with latches; no test sleeps.  A latch outlives the queue whose jobs wait for it.
#include "server/jobs/job_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <latch>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace selvage::server::jobs {
namespace {

Job job(std::function<void(std::stop_token)> work, std::string lane = {}, std::stop_token caller = {}) {
  return {.lane = std::move(lane), .caller = std::move(caller), .work = Work{std::move(work)}};
}

Admission submit(JobQueue& queue, Job work) {
  return queue.submit(work);
}

// Blocks until its token stops.
void wait_for_stop(const std::stop_token& stop) {
  std::latch stopped{1};
  const std::stop_callback on_stop{stop, [&] { stopped.count_down(); }};
  stopped.wait();
}

TEST(JobQueue, WithoutWorkersRunsInline) {
  JobQueue queue{0, 1};
  const auto here = std::this_thread::get_id();
  std::thread::id there;
  EXPECT_EQ(submit(queue, job([&](auto) { there = std::this_thread::get_id(); })), Admission::kAccepted);
  EXPECT_EQ(here, there);
}

TEST(JobQueue, RunsJobsAtTheSameTime) {
  std::latch both{2};
  std::latch done{2};
  JobQueue queue{2, 8};
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(submit(queue, job([&](auto) {
                       both.arrive_and_wait();  // returns only when both jobs have started
                       done.count_down();
                     })),
              Admission::kAccepted);
  }
  done.wait();
}

// This is the only test that notices a worker that is not woken for its job.
TEST(JobQueue, ExecutesAMixOfQuickAndLongJobsToTheLast) {
  constexpr int kThreads = 4;
  constexpr int kJobs = 2000;
  JobQueue queue{2, kThreads * kJobs, {1}};
  for (int round = 0; round < 3; ++round) {
    std::latch done{kThreads * kJobs};
    std::vector<std::jthread> threads;
    for (int t = 0; t < kThreads; ++t) {
      threads.emplace_back([&, t] {
        for (int i = 0; i < kJobs; ++i) {
          Job next = job([&](auto) { done.count_down(); });
          next.session = static_cast<std::uint64_t>(t);
          next.quick = (i * 7 + t) % 3 != 0;
          EXPECT_EQ(queue.submit(next), Admission::kAccepted);
        }
      });
    }
    done.wait();
  }
}

TEST(JobQueue, RunsTheJobsOfALaneInOrderOneAtATime) {
  std::vector<int> order;  // needs no mutex, because the lane runs one job at a time
  {
    std::latch first_may_end{1};
    JobQueue queue{4, 64};
    for (int i = 0; i < 32; ++i) {
      ASSERT_EQ(submit(queue, job(
                                  [&, i](auto) {
                                    if (i == 0) first_may_end.wait();
                                    order.push_back(i);
                                  },
                                  "m1")),
                Admission::kAccepted);
    }
    first_may_end.count_down();
  }
  std::vector<int> expected(32);
  for (int i = 0; i < 32; ++i) expected[static_cast<std::size_t>(i)] = i;
  EXPECT_EQ(order, expected);
}

TEST(JobQueue, ABusyLaneDoesNotDelayOthers) {
  std::latch release{1};
  std::latch other_done{1};
  JobQueue queue{2, 8};
  ASSERT_EQ(submit(queue, job([&](auto) { release.wait(); }, "m1")), Admission::kAccepted);
  ASSERT_EQ(submit(queue, job([&](auto) {}, "m1")), Admission::kAccepted);
  ASSERT_EQ(submit(queue, job([&](auto) { other_done.count_down(); }, "m2")), Admission::kAccepted);
  other_done.wait();
  release.count_down();
}

TEST(JobQueue, RefusesJobsBeyondItsCapacityAndLeavesThemUnchanged) {
  std::latch started{1};
  std::latch release{1};
  std::latch done{3};
  JobQueue queue{1, 2};
  const auto count = [&](auto) { done.count_down(); };
  ASSERT_EQ(submit(queue, job([&](auto) {
                     started.count_down();
                     release.wait();
                     done.count_down();
                   })),
            Admission::kAccepted);
  started.wait();
  ASSERT_EQ(submit(queue, job(count, "m1")), Admission::kAccepted);
  ASSERT_EQ(submit(queue, job(count, "m1")), Admission::kAccepted);  // a job that waits in its lane counts, too
  EXPECT_EQ(queue.waiting(), 2U);
  bool ran = false;
  Job refused = job([&](auto) { ran = true; });
  EXPECT_EQ(queue.submit(refused), Admission::kFull);
  EXPECT_TRUE(refused.work.valid());
  release.count_down();
  done.wait();
  EXPECT_FALSE(ran);
}

TEST(JobQueue, QuickJobsDoNotWaitForLongOnes) {
  std::latch started{2};
  std::latch release{1};
  std::latch quick_done{1};
  JobQueue queue{2, 8, {1}};
  for (const char* lane : {"m1", "m2"}) {
    ASSERT_EQ(submit(queue, job(
                                [&](auto) {
                                  started.count_down();
                                  release.wait();
                                },
                                lane)),
              Admission::kAccepted);
  }
  started.wait();
  bool long_ran = false;
  ASSERT_EQ(submit(queue, job([&](auto) { long_ran = true; }, "m3")), Admission::kAccepted);
  Job quick = job([&](auto) { quick_done.count_down(); }, "m4");
  quick.quick = true;
  ASSERT_EQ(queue.submit(quick), Admission::kAccepted);
  quick_done.wait();
  EXPECT_FALSE(long_ran);
  release.count_down();
  queue.drain();
  EXPECT_TRUE(long_ran);
}

TEST(JobQueue, QuickAndLongJobsOfALaneRunOneAtATime) {
  std::vector<int> order;  // needs no mutex, because the lane runs one job at a time
  {
    std::latch first_may_end{1};
    JobQueue queue{2, 64, {1}};
    for (int i = 0; i < 32; ++i) {
      Job next = job(
          [&, i](auto) {
            if (i == 0) first_may_end.wait();
            order.push_back(i);
          },
          "m1");
      next.quick = i % 3 == 1;
      ASSERT_EQ(queue.submit(next), Admission::kAccepted);
    }
    first_may_end.count_down();
  }
  ASSERT_EQ(order.size(), 32U);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(JobQueue, AFullQueueAdmitsASessionWithoutWaitingJobs) {
  std::latch release{1};
  std::latch started{1};
  JobQueue queue{1, 2};
  const auto of = [&](std::uint64_t session) {
    Job next = job([](auto) {});
    next.session = session;
    return queue.submit(next);
  };
  ASSERT_EQ(submit(queue, job([&](auto) {
                     started.count_down();
                     release.wait();
                   })),
            Admission::kAccepted);
  started.wait();
  EXPECT_EQ(of(1), Admission::kAccepted);
  EXPECT_EQ(of(1), Admission::kAccepted);
  EXPECT_EQ(of(1), Admission::kFull);
  EXPECT_EQ(of(2), Admission::kAccepted);
  EXPECT_EQ(of(2), Admission::kFull);
  EXPECT_EQ(queue.waiting(), 3U);
  release.count_down();
}

TEST(JobQueue, TheRetryTimeIncludesTheRunningJobs) {
  std::latch release{1};
  JobQueue queue{1, 1};
  for (int i = 0; i < 100; ++i) {  // jobs are known to be short
    std::latch done{1};
    ASSERT_EQ(submit(queue, job([&](auto) { done.count_down(); })), Admission::kAccepted);
    done.wait();
  }
  ASSERT_EQ(submit(queue, job([&](auto) { release.wait(); })), Admission::kAccepted);
  const int at_first = queue.retry_after_ms();
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds{30};
  while (queue.retry_after_ms() <= at_first + 10 && std::chrono::steady_clock::now() < patience) {
    std::this_thread::yield();
  }
  EXPECT_GT(queue.retry_after_ms(), at_first + 10);
  release.count_down();
}

TEST(JobQueue, AJobThatThrowsIsDestroyedAndAffectsNoOther) {
  std::latch dropped{1};
  std::latch next_ran{1};
  JobQueue queue{1, 8};
  const auto owned = std::shared_ptr<int>{new int{}, [&](const int* held) {
                                            delete held;
                                            dropped.count_down();
                                          }};
  ASSERT_EQ(submit(queue, job([held = owned](auto) { throw std::runtime_error{"on purpose"}; }, "m1")),
            Admission::kAccepted);
  ASSERT_EQ(submit(queue, job([&](auto) { next_ran.count_down(); }, "m1")), Admission::kAccepted);
  next_ran.wait();
  EXPECT_EQ(owned.use_count(), 1);
}

TEST(JobQueue, StopsARunningJobWhenItsCallerLeaves) {
  JobQueue queue{1, 8};
  std::stop_source caller;
  std::latch started{1};
  std::latch ended{1};
  ASSERT_EQ(submit(queue, job(
                              [&](const std::stop_token& stop) {
                                started.count_down();
                                wait_for_stop(stop);
                                ended.count_down();
                              },
                              {}, caller.get_token())),
            Admission::kAccepted);
  started.wait();
  caller.request_stop();
  ended.wait();
}

TEST(JobQueue, AJobWhoseCallerHasLeftStartsStopped) {
  JobQueue queue{1, 8};
  std::stop_source caller;
  std::latch release{1};
  std::latch ended{1};
  bool stopped = false;
  ASSERT_EQ(submit(queue, job([&](auto) { release.wait(); })), Admission::kAccepted);
  ASSERT_EQ(submit(queue, job(
                              [&](const std::stop_token& stop) {
                                stopped = stop.stop_requested();
                                ended.count_down();
                              },
                              {}, caller.get_token())),
            Admission::kAccepted);
  caller.request_stop();
  release.count_down();
  ended.wait();
  EXPECT_TRUE(stopped);
}

// A queue with one worker, which is blocked, and a time that the test sets.
class LateQueue : public ::testing::Test {
 protected:
  LateQueue() {
    EXPECT_EQ(submit(queue, job(
                                [this](auto) {
                                  started.count_down();
                                  release.wait();
                                },
                                "m1")),
              Admission::kAccepted);
    started.wait();
  }
  ~LateQueue() override { unblock(); }
  void unblock() {
    if (!std::exchange(unblocked, true)) release.count_down();
  }
  [[nodiscard]] Job until(std::chrono::seconds deadline, std::string lane = {}, std::stop_token caller = {}) {
    Job made = job([](auto) {}, std::move(lane), std::move(caller));
    made.deadline = now.load() + deadline;
    return made;
  }

  bool unblocked{};
  std::latch started{1};
  std::latch release{1};
  std::atomic<Job::Time> now{Job::Time{std::chrono::hours{1}}};
  JobQueue queue{1, 8, {}, [this] { return now.load(); }};
};

TEST_F(LateQueue, RefusesAJobWhenThoseBeforeItHaveWaitedLonger) {
  EXPECT_EQ(submit(queue, until(std::chrono::seconds{2})), Admission::kAccepted);  // nothing has waited yet
  now = now.load() + std::chrono::seconds{5};
  EXPECT_EQ(submit(queue, until(std::chrono::seconds{2})), Admission::kTooLate);
  EXPECT_EQ(submit(queue, until(std::chrono::seconds{9})), Admission::kAccepted);
  EXPECT_EQ(submit(queue, job([](auto) {})), Admission::kAccepted);  // one without a deadline may wait
}

TEST_F(LateQueue, RefusesAJobBehindALongOneOfItsLane) {
  now = now.load() + std::chrono::seconds{5};
  EXPECT_EQ(submit(queue, until(std::chrono::seconds{2}, "m1")), Admission::kTooLate);
  EXPECT_EQ(submit(queue, until(std::chrono::seconds{2}, "m2")), Admission::kAccepted);
}

TEST_F(LateQueue, AcceptsAJobBehindOneThatIsOnlyAboutToEnd) {
  const auto ending = std::make_shared<std::atomic<bool>>(false);
  std::latch behind{1};
  std::latch running{1};
  JobQueue other{2, 8, {}, [this] { return now.load(); }};
  Job next = job(
      [&](auto) {
        running.count_down();
        behind.wait();
      },
      "m3");
  next.ending = ending;
  ASSERT_EQ(submit(other, std::move(next)), Admission::kAccepted);
  running.wait();
  now = now.load() + std::chrono::seconds{5};
  EXPECT_EQ(submit(other, until(std::chrono::seconds{2}, "m3")), Admission::kTooLate);
  *ending = true;  // as when its call has been answered
  EXPECT_EQ(submit(other, until(std::chrono::seconds{2}, "m3")), Admission::kAccepted);
  behind.count_down();
}

TEST_F(LateQueue, RemovesAnsweredJobsAndServesTheirLanes) {
  const auto answered = std::make_shared<std::atomic<bool>>(false);
  std::latch ran{1};
  for (const char* lane : {"m1", "m2"}) {
    Job removed = job([](auto) { ADD_FAILURE() << "it was removed"; }, lane);
    removed.ending = answered;
    EXPECT_EQ(submit(queue, std::move(removed)), Admission::kAccepted);
  }
  EXPECT_EQ(submit(queue, job([&](auto) { ran.count_down(); }, "m2")), Admission::kAccepted);
  queue.remove_answered();
  EXPECT_EQ(queue.waiting(), 3U);
  *answered = true;
  queue.remove_answered();
  EXPECT_EQ(queue.waiting(), 1U);
  unblock();
  ran.wait();
}

TEST(JobQueue, DrainingStopsRunningJobsAndWaitsForAllAccepted) {
  std::latch started{1};
  JobQueue queue{1, 8};
  std::vector<bool> stopped;
  const auto record = [&](const std::stop_token& stop) { stopped.push_back(stop.stop_requested()); };
  ASSERT_EQ(submit(queue, job(
                              [&](const std::stop_token& stop) {
                                started.count_down();
                                wait_for_stop(stop);
                                record(stop);
                              },
                              "m1")),
            Admission::kAccepted);
  ASSERT_EQ(submit(queue, job(record, "m1")), Admission::kAccepted);
  ASSERT_EQ(submit(queue, job(record)), Admission::kAccepted);
  started.wait();
  queue.drain();
  EXPECT_EQ(stopped, (std::vector<bool>{true, true, true}));
  EXPECT_EQ(submit(queue, job(record)), Admission::kDraining);
  EXPECT_EQ(stopped.size(), 3U);
}

}  // namespace
}  // namespace selvage::server::jobs
