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

double milliseconds_since(Clock::time_point since) {
  return std::chrono::duration<double, std::milli>{Clock::now() - since}.count();
}

}  // namespace

JobQueue::JobQueue(std::size_t workers, std::size_t capacity, std::size_t brief_workers)
    : workers_{workers}, brief_workers_{workers == 0 ? 0 : brief_workers}, capacity_{capacity} {
  threads_.reserve(workers_ + brief_workers_);
  for (std::size_t i = 0; i < workers_ + brief_workers_; ++i) {
    threads_.emplace_back([this, reserved = i >= workers_] { serve(reserved); });
  }
}

JobQueue::~JobQueue() {
  drain();
}

Admission JobQueue::submit(Job& job) {
  std::unique_lock lock{mutex_};
  if (draining_) return Admission::kDraining;
  if (workers_ == 0) {
    const auto place = running_.emplace(running_.end());
    lock.unlock();
    run(std::move(job), place);
    return Admission::kAccepted;
  }
  if (ready_.size() + brief_.size() + behind_ >= capacity_ && waiting_.contains(job.session)) return Admission::kFull;
  ++waiting_[job.session];
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
  const bool brief = job.brief;
  const std::uint64_t session = job.session;
  (brief ? brief_ : ready_).push(session, std::move(job));
  wake(brief);
}

void JobQueue::wake(bool brief) {
  const bool reserved = brief && reserved_running_ < brief_workers_;
  (reserved ? brief_work_ : work_).notify_one();
}

void JobQueue::drain() {
  std::unique_lock lock{mutex_};
  draining_ = true;
  // A copy: a stop callback may run here, and must not find the mutex taken.
  std::vector<std::stop_source> stops;
  for (const Running& running : running_) stops.push_back(running.stop);
  lock.unlock();
  work_.notify_all();
  brief_work_.notify_all();
  for (const std::stop_source& stop : stops) stop.request_stop();
  lock.lock();
  drained_.wait(lock, [this] { return ready_.empty() && brief_.empty() && behind_ == 0 && running_.empty(); });
}

int JobQueue::retry_after_ms() const {
  const std::lock_guard lock{mutex_};
  double usual = usual_ms_;
  for (const Running& running : running_) usual = std::max(usual, milliseconds_since(running.since));
  const auto ahead = static_cast<double>(ready_.size() + brief_.size() + behind_ + 1);
  const auto hands = static_cast<double>(std::max<std::size_t>(workers_, 1));
  return static_cast<int>(std::clamp(usual * ahead / hands, kSoonest, kLatest));
}

std::size_t JobQueue::waiting() const {
  const std::lock_guard lock{mutex_};
  return ready_.size() + brief_.size() + behind_;
}

std::size_t JobQueue::running() const {
  const std::lock_guard lock{mutex_};
  return running_.size();
}

void JobQueue::serve(bool reserved) {
  std::unique_lock lock{mutex_};
  for (;;) {
    (reserved ? brief_work_ : work_).wait(lock, [&] { return has_work(reserved) || (draining_ && behind_ == 0); });
    if (!has_work(reserved)) return;
    Job job = reserved || ready_.empty() ? brief_.pop() : ready_.pop();
    if (--waiting_[job.session] == 0) waiting_.erase(job.session);
    const auto place = running_.emplace(running_.end(), Running{.reserved = reserved});
    reserved_running_ += reserved ? 1 : 0;
    if (draining_) place->stop.request_stop();
    lock.unlock();
    run(std::move(job), place);
    lock.lock();
  }
}

void JobQueue::run(Job job, Place place) {
  const std::string lane = job.lane;
  {
    const std::stop_callback caller_gone{job.caller, [source = place->stop]() mutable { source.request_stop(); }};
    auto outcome = job.work.get_future();
    job.work(place->stop.get_token());
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
  end(lane, place);
}

void JobQueue::end(const std::string& lane, Place place) {
  const std::lock_guard lock{mutex_};
  usual_ms_ += kOfLate * (milliseconds_since(place->since) - usual_ms_);
  reserved_running_ -= place->reserved ? 1 : 0;
  running_.erase(place);
  if (const auto found = lanes_.find(lane); found != lanes_.end()) {
    if (found->second.empty()) {
      lanes_.erase(found);
    } else {
      Job next = std::move(found->second.front());
      found->second.pop_front();
      --behind_;
      make_ready(std::move(next));
    }
  }
  if (draining_) {
    work_.notify_all();
    brief_work_.notify_all();
    drained_.notify_all();
  }
}

}  // namespace selvage
