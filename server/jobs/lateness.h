// Whether threads have lately waited for a processor when they woke up.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace selvage::server::jobs {

// Any thread may use it.
class Lateness {
 public:
  using Clock = std::chrono::steady_clock;

  // On idle processors a thread wakes up within 0.1 ms.  On busy ones it may wait for the end of another thread's time
  // slice, up to 4 ms.
  static constexpr std::chrono::microseconds kLate{500};
  // A late wake-up counts for three seconds, or until this many wake-ups in a row were punctual.  A few calls are late
  // before it counts: they must be fewer than a hundredth of those that follow.
  static constexpr std::chrono::seconds kLately{3};
  static constexpr std::int64_t kPunctual = 1000;
  // Threads are late often if two late wake-ups have fewer than this many punctual ones between them, and are less than
  // kLately apart.
  static constexpr std::int64_t kNear = 200;

  // A thread has begun to run at `now`, punctually or not.
  void record(bool late, Clock::time_point now) {
    if (!late) {
      ++punctual_;
      return;
    }
    const bool near = punctual_.exchange(0) < kNear;
    const Clock::time_point last = last_late_.exchange(now);
    if (near && now < last + kLately) last_near_ = now;
  }
  [[nodiscard]] bool lately(Clock::time_point now) const { return counts(last_late_, now); }
  [[nodiscard]] bool often(Clock::time_point now) const { return counts(last_near_, now); }

 private:
  [[nodiscard]] bool counts(Clock::time_point late, Clock::time_point now) const {
    return punctual_ < kPunctual && now < late + kLately;
  }

  std::atomic<std::int64_t> punctual_{};  // wake-ups since the last late one
  std::atomic<Clock::time_point> last_late_{Clock::time_point::min()};
  std::atomic<Clock::time_point> last_near_{Clock::time_point::min()};  // the second of two
};

}  // namespace selvage::server::jobs
