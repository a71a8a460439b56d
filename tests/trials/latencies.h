// The durations of calls, in milliseconds.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

namespace selvage::trials {

class Latencies {
 public:
  // Runs `work`, records its duration and returns its result.
  template <class Work>
  auto time(const Work& work) {
    const auto began = std::chrono::steady_clock::now();
    auto result = work();
    times_.push_back(std::chrono::duration<double, std::milli>{std::chrono::steady_clock::now() - began}.count());
    return result;
  }
  void add(double milliseconds) { times_.push_back(milliseconds); }
  void join(const Latencies& other) { times_.insert(times_.end(), other.times_.begin(), other.times_.end()); }
  // The quantile `p` of the durations, 0 <= p <= 1; 0 if there are none.
  [[nodiscard]] double part(double p) const {
    if (times_.empty()) return 0;
    std::vector<double> sorted = times_;
    std::sort(sorted.begin(), sorted.end());
    return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(p * static_cast<double>(sorted.size())))];
  }
  [[nodiscard]] std::string text() const {
    char line[160];
    std::snprintf(line, sizeof line, "%zu calls; ms p50 %.3f, p99 %.3f, most %.3f", times_.size(), part(0.5),
                  part(0.99), part(1));
    return line;
  }

 private:
  std::vector<double> times_;
};

}  // namespace selvage::trials
