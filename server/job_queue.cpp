#include "server/job_queue.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace selvage {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kOfLate = 0.1;                    // the weight of the last job in what is usual
constexpr double kSoonest = 20, kLatest = 10'000;  // milliseconds until a retry

}  // namespace

JobQueue::JobQueue(std::size_t workers, std::size_t capacity) : workers_{workers}, capacity_{capacity} {
  threads_.reserve(workers);
  for (std::size_t i = 0; i < workers; ++i) threads_.emplace_back([this] { serve(); });
}

JobQueue::~JobQueue() {
  drain();
}

Admission JobQueue::submit(Job& job) {
  std::unique_lock lock{mutex_};
  if (draining_) return Admission::kDraining;
  if (workers_ == 0) {
    const auto stop = stops_.emplace(stops_.end());
    lock.unlock();
    run(std::move(job), stop);
    return Admission::kAccepted;
  }
  if (ready_.size() + behind_ >= capacity_) return Admission::kFull;
  if (!job.lane.empty()) {
    const auto [lane, idle] = lanes_.try_emplace(job.lane);
    if (!idle) {
      lane->second.push_back(std::move(job));
      ++behind_;
      return Admission::kAccepted;
    }
  }
  const std::uint64_t session = job.session;
  ready_.push(session, std::move(job));
  lock.unlock();
  work_.notify_one();
  return Admission::kAccepted;
}

void JobQueue::drain() {
  std::unique_lock lock{mutex_};
  draining_ = true;
  // A copy: a stop callback may run here, and must not find the mutex taken.
  const std::vector<std::stop_source> running{stops_.begin(), stops_.end()};
  lock.unlock();
  work_.notify_all();
  for (const std::stop_source& stop : running) stop.request_stop();
  lock.lock();
  drained_.wait(lock, [this] { return ready_.empty() && behind_ == 0 && stops_.empty(); });
}

int JobQueue::retry_after_ms() const {
  const std::lock_guard lock{mutex_};
  const auto ahead = static_cast<double>(ready_.size() + behind_ + 1);
  const auto hands = static_cast<double>(std::max<std::size_t>(workers_, 1));
  return static_cast<int>(std::clamp(usual_ms_ * ahead / hands, kSoonest, kLatest));
}

std::size_t JobQueue::waiting() const {
  const std::lock_guard lock{mutex_};
  return ready_.size() + behind_;
}

std::size_t JobQueue::running() const {
  const std::lock_guard lock{mutex_};
  return stops_.size();
}

void JobQueue::serve() {
  std::unique_lock lock{mutex_};
  for (;;) {
    work_.wait(lock, [this] { return !ready_.empty() || (draining_ && behind_ == 0); });
    if (ready_.empty()) return;
    Job job = ready_.pop();
    const auto stop = stops_.emplace(stops_.end());
    if (draining_) stop->request_stop();
    lock.unlock();
    run(std::move(job), stop);
    lock.lock();
  }
}

void JobQueue::run(Job job, std::list<std::stop_source>::iterator stop) {
  const std::string lane = job.lane;
  const Clock::time_point began = Clock::now();
  {
    const std::stop_callback caller_gone{job.caller, [source = *stop]() mutable { source.request_stop(); }};
    auto outcome = job.work.get_future();
    job.work(stop->get_token());
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
  end(lane, stop, std::chrono::duration<double, std::milli>{Clock::now() - began}.count());
}

void JobQueue::end(const std::string& lane, std::list<std::stop_source>::iterator stop, double milliseconds) {
  const std::lock_guard lock{mutex_};
  usual_ms_ += kOfLate * (milliseconds - usual_ms_);
  stops_.erase(stop);
  if (const auto found = lanes_.find(lane); found != lanes_.end()) {
    if (found->second.empty()) {
      lanes_.erase(found);
    } else {
      const std::uint64_t session = found->second.front().session;
      ready_.push(session, std::move(found->second.front()));
      found->second.pop_front();
      --behind_;
    }
  }
  // This worker looks for its next job now, so nobody is woken for what the lane made ready.
  if (draining_) {
    work_.notify_all();
    drained_.notify_all();
  }
}

}  // namespace selvage
