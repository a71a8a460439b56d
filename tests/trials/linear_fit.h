// The least-squares line through points.
#pragma once

#include <cmath>
#include <vector>

namespace selvage::trials {

struct Sample {
  double at{}, value{};
};

struct LinearFit {
  double slope{};
  double error{};  // the slope's standard error, assuming independent samples
};

[[nodiscard]] inline LinearFit linear_fit(const std::vector<Sample>& samples) {
  const auto count = static_cast<double>(samples.size());
  if (samples.size() < 3) return {};
  double mean_at{}, mean_value{};
  for (const Sample& sample : samples) {
    mean_at += sample.at / count;
    mean_value += sample.value / count;
  }
  double spread{}, together{}, left{};
  for (const Sample& sample : samples) {
    spread += (sample.at - mean_at) * (sample.at - mean_at);
    together += (sample.at - mean_at) * (sample.value - mean_value);
  }
  if (spread == 0) return {};
  const double slope = together / spread;
  for (const Sample& sample : samples) {
    const double off = sample.value - mean_value - slope * (sample.at - mean_at);
    left += off * off;
  }
  return {slope, std::sqrt(left / (count - 2) / spread)};
}

}  // namespace selvage::trials
