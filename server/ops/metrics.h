// The daemon's metrics in Prometheus' text format 0.0.4: calls by method and outcome, their durations, and the current
// state.  Names follow https://prometheus.io/docs/practices/naming: base units, and `_total` for every counter.
//
// Methods that do not exist are counted as "unknown", so that no client can create labels.  Every function may be
// called from any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "server/ops/log.h"

namespace selvage::server::ops {

// Upper bounds of the histogram's buckets, in seconds; the last bucket has none.
inline constexpr std::array kBuckets{0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0};

class Metrics {
 public:
  void count(const AnsweredRequest& request);
  // The counters and histograms.
  [[nodiscard]] std::string text() const;

 private:
  struct Durations {
    std::array<std::uint64_t, kBuckets.size() + 1> buckets{};
    double sum{};  // seconds
    std::uint64_t count{};
  };
  struct Method {
    std::map<int, std::uint64_t> answers{};  // by the error's code; 0: no error
    Durations durations{};
  };

  mutable std::mutex mutex_;
  std::map<std::string, Method> methods_;
};

// One value, or several of the same name that differ in the value of one label.
struct Metric {
  enum class Type { kGauge, kCounter };
  struct Value {
    std::string_view label_value{};
    double value{};
  };
  std::string_view name{};
  Type type{};
  std::string_view help{};
  std::string_view label{};  // empty: one value, without a label
  std::vector<Value> values{};
};
[[nodiscard]] std::string metric_text(const Metric& metric);

}  // namespace selvage::server::ops
