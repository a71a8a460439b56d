// What the daemon counts, as Prometheus reads it (text format 0.0.4): answers by method and outcome, how long they
// took, and how things stand at the moment of asking.
//
// A method is a name from the wire; one that does not exist is counted as "unknown", so that no caller makes labels.
// May be called from any thread.
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

// Upper bounds of the histogram's buckets, in milliseconds; one more has none.
inline constexpr std::array kBucketsMs{0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0, 10000.0, 30000.0};

class Metrics {
 public:
  void count(const AnsweredRequest& request);
  // The counters and histograms.
  [[nodiscard]] std::string text() const;

 private:
  struct Durations {
    std::array<std::uint64_t, kBucketsMs.size() + 1> buckets{};
    double sum_ms{};
    std::uint64_t count{};
  };
  struct Method {
    std::map<int, std::uint64_t> answers{};  // by the error's code; 0: it went well
    Durations durations{};
  };

  mutable std::mutex mutex_;
  std::map<std::string, Method> methods_;
};

// A value, or several of one name, told apart by the value of one label.
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
