// Whether threads have lately waited for a processor when they woke up.
#pragma once

#include <atomic>
#include <chrono>

namespace selvage::server::jobs {

// Any thread may use it.
class Lateness {
 public:
  using Clock = std::chrono::steady_clock;

  // On idle processors a thread wakes up within 0.1 ms.  On busy ones it may wait for the end of another thread's time
  // slice, up to 4 ms.
  static constexpr std::chrono::microseconds kLate{500};
  // A late wake-up counts for three seconds, or until this many wake-ups in a row were punctual.  Even on idle
  // processors one in some thousands is late, and clients that make as many calls a second should not have to pay for
  // it.  On busy ones a few calls are late before it counts: they must be less than a hundredth of those that follow.
  static constexpr std::chrono::seconds kLately{3};
  static constexpr int kPunctual = 1000;

  // A thread began to run at `now`, `waited` after it had been woken up.
  void record(Clock::duration waited, Clock::time_point now) {
    if (waited >= kLate) {
      until_ = now + kLately;
      punctual_left_ = kPunctual;
    } else if (punctual_left_ > 0) {
      --punctual_left_;
    }
  }
  [[nodiscard]] bool lately(Clock::time_point now) const { return punctual_left_ > 0 && now < until_.load(); }

 private:
  std::atomic<Clock::time_point> until_{Clock::time_point::min()};
  std::atomic<int> punctual_left_{};
};

}  // namespace selvage::server::jobs
