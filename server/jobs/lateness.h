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
  // How long it counts: until then, or until threads have woken up so often in time.  On idle processors, too, a thread
  // is late now and then, which among thousands of quick calls a second is no reason.
  static constexpr std::chrono::seconds kLately{1};
  static constexpr int kTimes = 1000;

  // At `now` a thread ran that had been woken up so long ago.
  void record(Clock::duration waited, Clock::time_point now) {
    if (waited >= kLate) {
      until_ = now + kLately;
      times_left_ = kTimes;
    } else if (times_left_ > 0) {
      --times_left_;
    }
  }
  [[nodiscard]] bool lately(Clock::time_point now) const { return times_left_ > 0 && now < until_.load(); }

 private:
  std::atomic<Clock::time_point> until_{Clock::time_point::min()};
  std::atomic<int> times_left_{};
};

}  // namespace selvage::server::jobs
