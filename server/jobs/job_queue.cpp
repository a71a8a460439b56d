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

JobQueue::JobQueue(std::size_t workers, std::size_t capacity, std::size_t quick_workers)
    : workers_{workers}, capacity_{capacity} {
  if (workers == 0) return;
  threads_.reserve(workers + quick_workers);
  for (std::size_t i = 0; i < workers + quick_workers; ++i) {
    threads_.emplace_back([this, only_quick = i >= workers] { serve(only_quick); });
  }
}

JobQueue::~JobQueue() {
  drain();
}

Admission JobQueue::submit(Job& job) {
  std::unique_lock lock{mutex_};
  if (draining_) return Admission::kDraining;
  if (workers_ == 0) {
    const RunningJob running = running_.emplace(running_.end());
    lock.unlock();
    run(std::move(job), running);
    return Admission::kAccepted;
  }
  if (all_waiting() >= capacity_ && waiting_of_.contains(job.session)) return Admission::kFull;
  ++waiting_of_[job.session];
  if (!job.lane.empty()) {
    const auto [lane, idle] = lanes_.try_emplace(job.lane);
    if (!idle) {
      lane->second.push_back(std::move(job));
      ++blocked_;
      return Admission::kAccepted;
    }
  }
  make_ready(std::move(job));
  return Admission::kAccepted;
}

void JobQueue::make_ready(Job job) {
  if (job.quick) quick_.notify_one();
  work_.notify_one();
  const std::uint64_t session = job.session;
  ready_.push(session, std::move(job));
}

JobQueue::RunningJob JobQueue::begin(const Job& job) {
  const auto own = waiting_of_.find(job.session);
  if (--own->second == 0) waiting_of_.erase(own);
  const RunningJob running = running_.emplace(running_.end());
  if (draining_) running->stop.request_stop();
  return running;
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
  // The running jobs may take longer than all that have ended.
  double elapsed = 0;
  for (const Running& job : running_) elapsed += job.milliseconds() / static_cast<double>(running_.size());
  return static_cast<int>(std::clamp(std::max(recent_ms_, elapsed) * ahead / parallelism, kMinRetry, kMaxRetry));
}

std::size_t JobQueue::waiting() const {
  const std::lock_guard lock{mutex_};
  return all_waiting();
}

std::size_t JobQueue::running() const {
  const std::lock_guard lock{mutex_};
  return running_.size();
}

void JobQueue::serve(bool only_quick) {
  const auto accepts = [only_quick](const Job& job) { return job.quick || !only_quick; };
  std::condition_variable& changed = only_quick ? quick_ : work_;
  std::unique_lock lock{mutex_};
  for (;;) {
    std::optional<Job> job;
    changed.wait(lock, [&] { return (job = ready_.take(accepts)).has_value() || (draining_ && blocked_ == 0); });
    if (!job) return;
    const RunningJob running = begin(*job);
    lock.unlock();
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
  recent_ms_ += kWeightOfLastJob * (running->milliseconds() - recent_ms_);
  running_.erase(running);
  if (const auto found = lanes_.find(lane); found != lanes_.end()) {
    if (found->second.empty()) {
      lanes_.erase(found);
    } else {
      // Another worker may have to take it: this one may be for quick jobs only, or another session comes first.
      make_ready(std::move(found->second.front()));
      found->second.pop_front();
      --blocked_;
    }
  }
  if (draining_) {
    work_.notify_all();
    quick_.notify_all();
    drained_.notify_all();
  }
}

}  // namespace selvage::server::jobs
