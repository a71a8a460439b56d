// Limits how often something is logged: at most once per interval, with the number of lines that were left out.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace selvage::server::ops {

class Throttle {
 public:
  using Time = std::chrono::steady_clock::time_point;
  Throttle() = default;
  explicit Throttle(std::chrono::milliseconds interval) : interval_{interval} {}

  // If a line may be logged now, returns how many were withheld since the last one; otherwise returns nothing.
  [[nodiscard]] std::optional<std::uint64_t> pass(Time now);

 private:
  std::chrono::milliseconds interval_{1000};
  std::optional<Time> last_;
  std::uint64_t withheld_{};
};

}  // namespace selvage::server::ops
