// The server's clock: it gives the time, and calls a function at each deadline, from a single thread that sleeps until
// the next deadline.  A test can advance it, as if time had passed.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace selvage::server::jobs {

class DeadlineClock {
 public:
  using Duration = std::chrono::steady_clock::duration;
  using Time = std::chrono::steady_clock::time_point;

  // A deadline that is pending as long as this object lives.
  class Alarm {
   public:
    Alarm() = default;
    Alarm(Alarm&& other) noexcept : clock_{std::exchange(other.clock_, nullptr)}, key_{std::move(other.key_)} {}
    Alarm& operator=(Alarm&& other) noexcept {
      std::swap(clock_, other.clock_);
      std::swap(key_, other.key_);
      return *this;
    }
    ~Alarm() {
      if (clock_) clock_->remove(key_);
    }

    // The time until it, negative when it has passed; none when it was never set.
    [[nodiscard]] std::optional<Duration> left() const {
      return clock_ ? std::optional{key_.first - clock_->now()} : std::nullopt;
    }

   private:
    friend class DeadlineClock;
    using Key = std::pair<Time, std::uint64_t>;
    Alarm(DeadlineClock& clock, Key key) : clock_{&clock}, key_{key} {}
    DeadlineClock* clock_{};
    Key key_{};
  };

  DeadlineClock();

  // Any thread.
  [[nodiscard]] Time now() const { return std::chrono::steady_clock::now() + advanced_.load(); }
  // Calls `on_time` at that time, on the clock's thread; it must not block.  REQUIRES: the clock outlives the alarm.
  [[nodiscard]] Alarm at(Time time, std::function<void()> on_time);
  // For tests: advances the clock by this time.
  void advance(Duration by);
  // Waits for the function that is being called, if any, and calls no further ones.
  void stop();

 private:
  void remove(const Alarm::Key& key);
  void tick(const std::stop_token& stop);

  std::atomic<Duration> advanced_{Duration{}};
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::uint64_t alarms_set_{};
  std::map<Alarm::Key, std::function<void()>> alarms_;
  // When the thread wakes up next.  Removing an alarm does not change it, because one needless wake-up costs less than
  // notifying the thread for every call that ends in time.
  Time wakes_at_{Time::max()};
  std::jthread thread_;  // last, because it uses the other members
};

}  // namespace selvage::server::jobs
