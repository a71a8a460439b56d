#include "server/jobs/job_queue.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

namespace selvage::server::jobs {
namespace {

constexpr double kOfLate = 0.1;                    // the weight of the last job in what is usual
constexpr double kSoonest = 20, kLatest = 10'000;  // milliseconds until a retry

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
    const UnderWay now = running_.emplace(running_.end());
    lock.unlock();
    run(std::move(job), now);
    return Admission::kAccepted;
  }
  if (all_waiting() >= capacity_ && waiting_of_.contains(job.session)) return Admission::kFull;
  ++waiting_of_[job.session];
  if (!job.lane.empty()) {
    const auto [lane, idle] = lanes_.try_emplace(job.lane);
    if (!idle) {
      lane->second.push_back(std::move(job));
      ++behind_;
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

JobQueue::UnderWay JobQueue::begin(const Job& job) {
  const auto own = waiting_of_.find(job.session);
  if (--own->second == 0) waiting_of_.erase(own);
  const UnderWay now = running_.emplace(running_.end());
  if (draining_) now->stop.request_stop();
  return now;
}

void JobQueue::drain() {
  std::unique_lock lock{mutex_};
  draining_ = true;
  // A copy: a stop callback may run here, and must not find the mutex taken.
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
  // What is under way may be longer than all that has ended.
  double so_far = 0;
  for (const Running& job : running_) so_far += job.milliseconds() / static_cast<double>(running_.size());
  return static_cast<int>(std::clamp(std::max(usual_ms_, so_far) * ahead / parallelism, kSoonest, kLatest));
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
  const auto suits = [only_quick](const Job& job) { return job.quick || !only_quick; };
  std::condition_variable& news = only_quick ? quick_ : work_;
  std::unique_lock lock{mutex_};
  for (;;) {
    std::optional<Job> job;
    news.wait(lock, [&] { return (job = ready_.take(suits)).has_value() || (draining_ && behind_ == 0); });
    if (!job) return;
    const UnderWay now = begin(*job);
    lock.unlock();
    run(*std::move(job), now);
    lock.lock();
  }
}

void JobQueue::run(Job job, UnderWay now) {
  const std::string lane = job.lane;
  {
    const std::stop_callback caller_gone{job.caller, [source = now->stop]() mutable { source.request_stop(); }};
    auto outcome = job.work.get_future();
    job.work(now->stop.get_token());
    try {
      outcome.get();
    } catch (const std::exception& error) {
      spdlog::error("a job threw: {}", error.what());
    } catch (...) {
      spdlog::error("a job threw something that is not an exception");
    }
    // The job goes before its lane moves on: what it owned, such as an unused reply, is settled first.
    job.work = {};
  }
  end(lane, now);
}

void JobQueue::end(const std::string& lane, UnderWay now) {
  const std::lock_guard lock{mutex_};
  usual_ms_ += kOfLate * (now->milliseconds() - usual_ms_);
  running_.erase(now);
  if (const auto found = lanes_.find(lane); found != lanes_.end()) {
    if (found->second.empty()) {
      lanes_.erase(found);
    } else {
      // Another may have to take it: this worker may not suit, or take another session's first.
      make_ready(std::move(found->second.front()));
      found->second.pop_front();
      --behind_;
    }
  }
  if (draining_) {
    work_.notify_all();
    quick_.notify_all();
    drained_.notify_all();
  }
}

}  // namespace selvage::server::jobs
