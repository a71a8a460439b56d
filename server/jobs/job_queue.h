// The worker pool: jobs in, at most `capacity` waiting, each told when to stop.
//
// Sessions take turns: however many jobs one of them has waiting, another's next job waits for one of each.  Nor does a
// full queue refuse who has none waiting: its capacity is shared by those who have, one job of each other comes on top.
//
// Some workers take only jobs that are quick by their own word: these wait neither for long ones nor for all workers.
//
// A job may name a lane; the jobs of one lane run one at a time, in the order they came.  A marker's id is
// the lane of what changes it.  The queue owns every worker and every stop_source: a job is asked to stop
// when its caller is gone or when the queue drains, and a job that starts after either finds its token
// already stopped. With no workers a job runs inside submit(), for tests that want no threads.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <future>
#include <list>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "server/jobs/fair_line.h"

namespace selvage::server::jobs {

// Move-only, unlike std::function, so that a job can own its ReplyOnce.
using Work = std::packaged_task<void(std::stop_token)>;

struct Job {
  std::uint64_t session{};  // whose turn it takes
  std::string lane;         // empty: none
  bool quick{};             // never takes long
  std::stop_token caller;   // stops when whoever asked is gone
  Work work;                // what it throws is logged and ends this job only
};

enum class Admission { kAccepted, kFull, kDraining };

class JobQueue {
 public:
  // `quick_workers` more beside the `workers`, when there are any.
  JobQueue(std::size_t workers, std::size_t capacity, std::size_t quick_workers = 0);
  ~JobQueue();  // drains
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  // A job that is not accepted is left as it was.
  [[nodiscard]] Admission submit(Job& job);

  // Refuses what comes from now on, asks every job to stop, returns when the last has ended.
  void drain();

  [[nodiscard]] std::size_t workers() const { return workers_; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  // When a full queue is likely to have room again: jobs waiting times what one took of late, or has taken by now.
  [[nodiscard]] int retry_after_ms() const;
  [[nodiscard]] std::size_t waiting() const;
  [[nodiscard]] std::size_t running() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Running {
    std::stop_source stop;
    Clock::time_point began{Clock::now()};
    [[nodiscard]] double milliseconds() const {
      return std::chrono::duration<double, std::milli>{Clock::now() - began}.count();
    }
  };
  using UnderWay = std::list<Running>::iterator;

  void serve(bool only_quick);
  void run(Job job, UnderWay now);
  void end(const std::string& lane, UnderWay now);
  // All under the mutex.
  void make_ready(Job job);
  [[nodiscard]] UnderWay begin(const Job& job);
  [[nodiscard]] std::size_t all_waiting() const { return ready_.size() + behind_; }

  const std::size_t workers_;
  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable work_;     // a job is ready, or no more will come
  std::condition_variable quick_;    // the same, of quick jobs
  std::condition_variable drained_;  // the last has ended
  FairLine<Job> ready_;
  std::map<std::string, std::deque<Job>> lanes_;     // the lanes with a job ready or running, and what waits behind it
  std::size_t behind_{};                             // jobs waiting in lanes_
  std::map<std::uint64_t, std::size_t> waiting_of_;  // by session, ready or behind; none: not there
  std::list<Running> running_;
  double usual_ms_{100};  // a job's, of late
  bool draining_{};
  std::vector<std::jthread> threads_;
};

}  // namespace selvage::server::jobs
