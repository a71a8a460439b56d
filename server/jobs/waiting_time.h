// A smoothed average of how long recent jobs of one kind have waited for a worker.
#pragma once

#include <chrono>

namespace selvage::server::jobs {

class WaitingTime {
 public:
  using Duration = std::chrono::duration<double, std::milli>;

  void record(Duration wait) { recent_ += kWeightOfLast * (wait - recent_); }
  [[nodiscard]] Duration recent() const { return recent_; }

 private:
  static constexpr double kWeightOfLast = 0.3;
  Duration recent_{};
};

}  // namespace selvage::server::jobs
