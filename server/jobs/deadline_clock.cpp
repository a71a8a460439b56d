#include "server/jobs/deadline_clock.h"

#include "server/jobs/prompt_thread.h"

namespace selvage::server::jobs {

DeadlineClock::DeadlineClock() : thread_{[this](const std::stop_token& stop) { tick(stop); }} {}

DeadlineClock::Alarm DeadlineClock::at(Time time, std::function<void()> on_time) {
  const std::lock_guard lock{mutex_};
  const Alarm::Key key{time, ++alarms_set_};
  alarms_.emplace(key, std::move(on_time));
  if (time < wakes_at_) changed_.notify_all();
  return Alarm{*this, key};
}

void DeadlineClock::advance(Duration by) {
  const std::lock_guard lock{mutex_};
  advanced_ = advanced_.load() + by;
  changed_.notify_all();
}

void DeadlineClock::stop() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

void DeadlineClock::remove(const Alarm::Key& key) {
  decltype(alarms_)::node_type removed;  // destroyed without the lock: it may own much
  const std::lock_guard lock{mutex_};
  removed = alarms_.extract(key);
}

void DeadlineClock::tick(const std::stop_token& stop) {
  run_promptly(Promptness::kAlarm);
  std::unique_lock lock{mutex_};
  while (!stop.stop_requested()) {
    const Time next = alarms_.empty() ? Time::max() : alarms_.begin()->first.first;
    if (now() < next) {
      wakes_at_ = next;
      const Duration advanced = advanced_;
      const auto earlier = [&] {
        return advanced != advanced_.load() || (!alarms_.empty() && alarms_.begin()->first.first < next);
      };
      if (next == Time::max()) {
        changed_.wait(lock, stop, earlier);  // wait_until() overflows at Time::max()
      } else {
        changed_.wait_until(lock, stop, next - advanced, earlier);
      }
      continue;
    }
    const auto on_time = std::move(alarms_.begin()->second);
    alarms_.erase(alarms_.begin());
    lock.unlock();
    woke_up_after(now() - next);
    on_time();
    lock.lock();
  }
}

}  // namespace selvage::server::jobs
