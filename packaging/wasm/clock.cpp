// The daemon's clock without a thread (server/jobs/deadline_clock.h): an alarm goes off when somebody looks whether to
// stop after its time.
#include <stop_token>

#include "server/jobs/deadline_clock.h"

namespace selvage::server::jobs {

DeadlineClock::DeadlineClock() {
  static DeadlineClock* clock = nullptr;
  clock = this;
  selvage_wasm::before_looking = [] { clock->tick({}); };
}

DeadlineClock::Alarm DeadlineClock::at(Time time, std::function<void()> on_time) {
  const Alarm::Key key{time, ++alarms_set_};
  alarms_.emplace(key, std::move(on_time));
  return Alarm{*this, key};
}

void DeadlineClock::advance(Duration by) {
  advanced_ = advanced_.load() + by;
}

void DeadlineClock::stop() {
  selvage_wasm::before_looking = nullptr;
}

void DeadlineClock::remove(const Alarm::Key& key) {
  alarms_.erase(key);
}

void DeadlineClock::tick(const std::stop_token&) {
  while (!alarms_.empty() && alarms_.begin()->first.first <= now()) {
    const auto on_time = std::move(alarms_.begin()->second);
    alarms_.erase(alarms_.begin());
    on_time();
  }
}

}  // namespace selvage::server::jobs
