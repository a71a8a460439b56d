#include "server/jobs/job_queue.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

namespace selvage::server::jobs {
namespace {

constexpr double kWeightOfLastJob = 0.1;              // in the smoothed time of a recent job
constexpr double kMinRetry = 20, kMaxRetry = 10'000;  // milliseconds

}  // namespace

JobQueue::JobQueue(std::size_t workers, std::size_t capacity, QuickWorkers quick, Now now)
    : workers_{workers}, capacity_{capacity}, now_{std::move(now)} {
  if (workers == 0) return;
  threads_.reserve(workers + quick.count);
  for (std::size_t i = 0; i < workers; ++i) threads_.emplace_back([this] { serve({}); });
  for (std::size_t i = 0; i < quick.count; ++i) threads_.emplace_back([this, quick] { serve(quick.promptness); });
}

JobQueue::~JobQueue() {
  drain();
}

Admission JobQueue::submit(Job& job) {
  std::unique_lock lock{mutex_};
  if (draining_) return Admission::kDraining;
  if (workers_ == 0) {
    const RunningJob running = running_.insert(running_.end(), {{}, now_()});
    lock.unlock();
    run(std::move(job), running);
    return Admission::kAccepted;
  }
  if (all_waiting() >= capacity_ && waiting_of_.contains(job.session)) return Admission::kFull;
  if (job.deadline && now_() + expected_wait(job) > *job.deadline) return Admission::kTooLate;
  ++waiting_of_[job.session];
  if (!job.lane.empty()) {
    const auto [lane, idle] = lanes_.try_emplace(job.lane);
    if (!idle) {
      lane->second.blocked.push_back(std::move(job));
      ++blocked_;
      return Admission::kAccepted;
    }
  }
  std::condition_variable& changed = make_ready(std::move(job));
  lock.unlock();  // otherwise the woken thread would have to wait for the mutex first
  changed.notify_one();
  return Admission::kAccepted;
}

// Workers serve whichever job is next.  So a new job is expected to wait as long as recent jobs have waited, or as long
// as the jobs that are waiting now if that is longer.  Behind a running job of its lane it is expected to wait as long
// again as that job has taken so far.
JobQueue::Milliseconds JobQueue::expected_wait(const Job& job) const {
  const std::size_t idle = idle_ + (job.quick ? idle_quick_ : 0);
  Milliseconds wait{};
  if (idle <= ready_.size()) {
    wait = std::max((job.quick ? waited_quick_ : waited_).recent(), longest_wait(job.quick));
  }
  const auto lane = lanes_.find(job.lane);
  if (lane == lanes_.end() || !lane->second.running) return wait;
  const auto& ending = lane->second.ending;
  if (!ending || !*ending) wait = std::max<Milliseconds>(wait, now_() - *lane->second.running);
  return wait;
}

JobQueue::Milliseconds JobQueue::longest_wait(bool quick) const {
  Milliseconds longest{};
  ready_.for_each([&](const Job& job) {
    if (job.quick == quick) longest = std::max<Milliseconds>(longest, now_() - job.ready_at);
  });
  return longest;
}

// Returns the condition variable to notify, so that a worker takes the job.  For a quick job it is that of the workers
// for quick jobs if more of these are idle than there are ready quick jobs, each of which has woken one already.
std::condition_variable& JobQueue::make_ready(Job job) {
  const bool quick_takes_it = job.quick && idle_quick_ > ready_quick_;
  ready_quick_ += job.quick ? 1 : 0;
  job.ready_at = now_();
  job.wakes_worker = quick_takes_it;
  const std::uint64_t session = job.session;
  ready_.push(session, std::move(job));
  return quick_takes_it ? quick_ : work_;
}

void JobQueue::count_as_gone(std::uint64_t session) {
  const auto own = waiting_of_.find(session);
  if (--own->second == 0) waiting_of_.erase(own);
}

JobQueue::RunningJob JobQueue::begin(const Job& job) {
  count_as_gone(job.session);
  ready_quick_ -= job.quick ? 1 : 0;
  const Job::Time now = now_();
  (job.quick ? waited_quick_ : waited_).record(now - job.ready_at);
  if (const auto lane = lanes_.find(job.lane); lane != lanes_.end()) {
    lane->second.running = now;
    lane->second.ending = job.ending;
  }
  const RunningJob running = running_.insert(running_.end(), {{}, now});
  if (draining_) running->stop.request_stop();
  return running;
}

void JobQueue::remove_answered() {
  std::vector<Job> removed;  // destroyed without the lock: a job may own the last reference to its call
  const std::lock_guard lock{mutex_};
  removed = take_answered();
  if (draining_ && !removed.empty()) notify_of_drain();
}

std::vector<Job> JobQueue::take_answered() {
  const auto answered = [](const Job& job) { return job.ending && *job.ending; };
  std::vector<Job> removed;
  for (auto& [name, lane] : lanes_) {
    const auto stay = std::stable_partition(lane.blocked.begin(), lane.blocked.end(), answered);
    blocked_ -= static_cast<std::size_t>(stay - lane.blocked.begin());
    std::move(lane.blocked.begin(), stay, std::back_inserter(removed));
    lane.blocked.erase(lane.blocked.begin(), stay);
  }
  std::vector<Job> ready = ready_.take_all(answered);
  for (Job& job : ready) {
    ready_quick_ -= job.quick ? 1 : 0;
    (job.quick ? waited_quick_ : waited_).record(now_() - job.ready_at);
    free_lane(job.lane);
    removed.push_back(std::move(job));
  }
  for (const Job& job : removed) count_as_gone(job.session);
  return removed;
}

void JobQueue::drain() {
  std::unique_lock lock{mutex_};
  draining_ = true;
  // A copy, because a stop callback may run here, and the mutex must not be locked then.
  const std::vector<Running> running{running_.begin(), running_.end()};
  lock.unlock();
  work_.notify_all();
  quick_.notify_all();
  for (const Running& job : running) job.stop.request_stop();
  lock.lock();
  drained_.wait(lock, [this] { return all_waiting() == 0 && running_.empty(); });
}

int JobQueue::retry_after_ms() const {
  const std::lock_guard lock{mutex_};
  const auto ahead = static_cast<double>(all_waiting() + 1);
  const auto parallelism = static_cast<double>(std::max<std::size_t>(workers_, 1));
  // The running jobs may have taken longer than any job that has ended.
  Milliseconds elapsed{};
  for (const Running& job : running_)
    elapsed += Milliseconds{now_() - job.began} / static_cast<double>(running_.size());
  return static_cast<int>(
      std::clamp(std::max(recent_ms_, elapsed.count()) * ahead / parallelism, kMinRetry, kMaxRetry));
}

JobQueue::Milliseconds JobQueue::longest_quick_wait() const {
  const std::lock_guard lock{mutex_};
  return longest_wait(true);
}

std::size_t JobQueue::waiting() const {
  const std::lock_guard lock{mutex_};
  return all_waiting();
}

std::size_t JobQueue::running() const {
  const std::lock_guard lock{mutex_};
  return running_.size();
}

void JobQueue::serve(std::optional<Promptness> only_quick) {
  if (only_quick) run_promptly(*only_quick);
  const auto accepts = [&only_quick](const Job& job) { return job.quick || !only_quick; };
  std::condition_variable& changed = only_quick ? quick_ : work_;
  std::size_t& idle = only_quick ? idle_quick_ : idle_;
  std::unique_lock lock{mutex_};
  for (;;) {
    std::optional<Job> job;
    ++idle;
    changed.wait(lock, [&] { return (job = ready_.take(accepts)).has_value() || (draining_ && blocked_ == 0); });
    --idle;
    if (!job) return;
    const RunningJob running = begin(*job);
    const Job::Time began = running->began;
    lock.unlock();
    if (only_quick) woke_up_after(job->wakes_worker ? began - job->ready_at : Job::Time::duration{});
    run(*std::move(job), running);
    lock.lock();
  }
}

void JobQueue::run(Job job, RunningJob running) {
  const std::string lane = job.lane;
  {
    const std::stop_callback caller_gone{job.caller, [source = running->stop]() mutable { source.request_stop(); }};
    auto outcome = job.work.get_future();
    job.work(running->stop.get_token());
    try {
      outcome.get();
    } catch (const std::exception& error) {
      spdlog::error("a job threw: {}", error.what());
    } catch (...) {
      spdlog::error("a job threw something that is not an exception");
    }
    // The job is destroyed before the next of its lane starts, so that what it owned, such as an unused reply, is
    // settled first.
    job.work = {};
  }
  end(lane, running);
}

void JobQueue::end(const std::string& lane, RunningJob running) {
  const std::lock_guard lock{mutex_};
  recent_ms_ += kWeightOfLastJob * (Milliseconds{now_() - running->began}.count() - recent_ms_);
  running_.erase(running);
  free_lane(lane);
  if (draining_) notify_of_drain();
}

void JobQueue::notify_of_drain() {
  work_.notify_all();
  quick_.notify_all();
  drained_.notify_all();
}

// The first job of the lane has ended or was removed.
void JobQueue::free_lane(const std::string& lane) {
  const auto found = lanes_.find(lane);
  if (found == lanes_.end()) return;
  if (found->second.blocked.empty()) {
    lanes_.erase(found);
    return;
  }
  // Another worker may have to take it: this one may be for quick jobs only, or another session comes first.
  Job next = std::move(found->second.blocked.front());
  found->second.blocked.pop_front();
  found->second.running.reset();
  --blocked_;
  make_ready(std::move(next)).notify_one();
}

}  // namespace selvage::server::jobs
