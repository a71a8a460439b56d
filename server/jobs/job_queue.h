// The worker pool: jobs wait in a queue of limited capacity, and each job has a token that asks it to stop.
//
// Sessions are served round-robin, so a session with many queued jobs delays another session by at most one job.  A
// session without queued jobs is always admitted, even when the queue is full.  A job with a deadline is refused at
// once if it would have to wait and recent jobs have waited longer than its deadline allows.
//
// Some workers take only jobs that are declared quick, so that quick jobs wait neither behind long jobs nor for busy
// workers.  They do not wait for the end of a long job's time slice either (prompt_thread.h).
//
// A job may name a lane; the jobs of one lane are executed one at a time, in order of arrival.  A marker's id is the
// lane of its changes.  The queue owns every worker and every stop_source: a job is asked to stop when its caller no
// longer waits or when the queue drains, and a job that starts after either finds its token already stopped.  Without
// workers, a job is executed inside submit(), for tests that want no threads.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "server/jobs/fair_queue.h"
#include "server/jobs/prompt_thread.h"
#include "server/jobs/waiting_time.h"

namespace selvage::server::jobs {

// Move-only, unlike std::function, so that a job can own its ReplyOnce.
using Work = std::packaged_task<void(std::stop_token)>;

struct Job {
  using Time = std::chrono::steady_clock::time_point;

  std::uint64_t session{};                            // the session whose turn it uses
  std::string lane;                                   // empty: none
  bool quick{};                                       // never takes long
  std::optional<Time> deadline{};                     // useless if it has not started by then
  std::stop_token caller;                             // stops when the caller wants the job to stop
  Work work;                                          // an exception is logged and ends only this job
  std::shared_ptr<const std::atomic<bool>> ending{};  // true: it has been answered, or is about to; null: not known
  Time ready_at{};                                    // when only workers were missing; set by the queue
  bool wakes_worker{};                                // an idle one for quick jobs, at that time; set by the queue
};

enum class Admission { kAccepted, kFull, kTooLate, kDraining };

// Workers for quick jobs only.
struct QuickWorkers {
  std::size_t count{};
  Promptness promptness{Promptness::kSoon};
};

class JobQueue {
 public:
  using Milliseconds = WaitingTime::Duration;
  using Now = std::function<Job::Time()>;

  // The `quick` workers are additional to `workers`, unless that is 0.  `now` gives the time, from any thread.
  JobQueue(std::size_t workers, std::size_t capacity, QuickWorkers quick = {},
           Now now = std::chrono::steady_clock::now);
  ~JobQueue();  // drains
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  // A job that is not accepted is left unchanged.
  [[nodiscard]] Admission submit(Job& job);
  // Removes the waiting jobs that have been answered, without executing them.
  void remove_answered();

  // Accepts no more jobs, asks every job to stop, and returns when the last one has ended.
  void drain();

  [[nodiscard]] std::size_t workers() const { return workers_; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  // An estimate of when a full queue will have room again: the number of waiting jobs times the duration of a recent
  // job, or of the running jobs if they have taken longer.
  [[nodiscard]] int retry_after_ms() const;
  // The longest time that a quick job has been waiting for a worker; 0 if none waits.
  [[nodiscard]] Milliseconds longest_quick_wait() const;
  [[nodiscard]] std::size_t waiting() const;
  [[nodiscard]] std::size_t running() const;

 private:
  struct Running {
    std::stop_source stop;
    Job::Time began;
  };
  using RunningJob = std::list<Running>::iterator;
  struct Lane {
    std::deque<Job> blocked;                          // they wait for the lane's first job, which is ready or running
    std::optional<Job::Time> running;                 // since when
    std::shared_ptr<const std::atomic<bool>> ending;  // of that job
  };

  void serve(std::optional<Promptness> only_quick);
  void run(Job job, RunningJob running);
  void end(const std::string& lane, RunningJob running);
  // REQUIRE the mutex.  The caller notifies the condition variable that make_ready() returns.
  std::condition_variable& make_ready(Job job);
  void free_lane(const std::string& lane);
  void count_as_gone(std::uint64_t session);
  [[nodiscard]] RunningJob begin(const Job& job);
  [[nodiscard]] std::size_t all_waiting() const { return ready_.size() + blocked_; }
  [[nodiscard]] Milliseconds longest_wait(bool quick) const;
  [[nodiscard]] Milliseconds expected_wait(const Job& job) const;
  [[nodiscard]] std::vector<Job> take_answered();
  void notify_of_drain();

  const std::size_t workers_;
  const std::size_t capacity_;
  const Now now_;
  mutable std::mutex mutex_;
  std::condition_variable work_;     // a job is ready, or no more will come
  std::condition_variable quick_;    // a quick job is ready, or no more will come
  std::condition_variable drained_;  // the last job has ended
  FairQueue<Job> ready_;
  std::map<std::string, Lane> lanes_;                // those with a ready or running job
  std::size_t blocked_{};                            // jobs waiting in lanes_
  std::map<std::uint64_t, std::size_t> waiting_of_;  // by session, ready or blocked; sessions with none are absent
  std::list<Running> running_;
  std::size_t idle_{}, idle_quick_{};  // workers of either kind that wait for a job
  std::size_t ready_quick_{};          // quick jobs in ready_
  WaitingTime waited_, waited_quick_;  // for a worker, by jobs that are long and quick
  double recent_ms_{100};              // the time of a recent job, smoothed
  bool draining_{};
  std::vector<std::jthread> threads_;
};

}  // namespace selvage::server::jobs
