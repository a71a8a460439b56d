#include "server/ops/metrics.h"

#include <algorithm>

#include "protocol/rpc/json_rpc.h"

namespace selvage::server::ops {
namespace {

std::string heading(std::string_view name, std::string_view type, std::string_view help) {
  std::string text = "# HELP ";
  text.append(name).append(" ").append(help).append("\n# TYPE ").append(name).append(" ").append(type).append("\n");
  return text;
}

std::string line(std::string_view name, std::string_view labels, double value) {
  std::string text{name};
  if (!labels.empty()) text.append("{").append(labels).append("}");
  return text + " " + protocol::json::number_text(value) + "\n";
}

std::string labelled(std::string_view label, std::string_view value) {
  return std::string{label}.append("=\"").append(value).append("\"");
}

bool is_plain(std::string_view name) {
  return name.find_first_of("\"\\\n") == std::string_view::npos;
}

}  // namespace

void Metrics::count(const AnsweredRequest& request) {
  const bool known =
      request.code != static_cast<int>(protocol::rpc::RpcCode::kMethodNotFound) && is_plain(request.method);
  const double seconds = request.milliseconds / 1000;
  const auto bucket = std::lower_bound(kBuckets.begin(), kBuckets.end(), seconds) - kBuckets.begin();
  const std::lock_guard lock{mutex_};
  Method& method = methods_[known ? request.method : "unknown"];
  ++method.answers[request.code];
  ++method.durations.buckets[static_cast<std::size_t>(bucket)];
  ++method.durations.count;
  method.durations.sum += seconds;
}

std::string Metrics::text() const {
  constexpr std::string_view kAnswers = "selvage_calls_total";
  constexpr std::string_view kDuration = "selvage_call_duration_seconds";
  const std::lock_guard lock{mutex_};
  std::string text = heading(kAnswers, "counter", "Calls answered, by method and by error code (0: a result).");
  for (const auto& [name, method] : methods_) {
    for (const auto& [code, count] : method.answers) {
      const std::string labels = labelled("method", name) + "," + labelled("code", std::to_string(code));
      text += line(kAnswers, labels, static_cast<double>(count));
    }
  }
  text += heading(kDuration, "histogram", "Time from a call's arrival to its answer.");
  for (const auto& [name, method] : methods_) {
    const std::string labels = labelled("method", name);
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < method.durations.buckets.size(); ++i) {
      below += method.durations.buckets[i];
      const std::string bound = i < kBuckets.size() ? protocol::json::number_text(kBuckets.at(i)) : "+Inf";
      text +=
          line(std::string{kDuration} + "_bucket", labels + "," + labelled("le", bound), static_cast<double>(below));
    }
    text += line(std::string{kDuration} + "_sum", labels, method.durations.sum);
    text += line(std::string{kDuration} + "_count", labels, static_cast<double>(method.durations.count));
  }
  return text;
}

std::string metric_text(const Metric& metric) {
  std::string text = heading(metric.name, metric.type == Metric::Type::kGauge ? "gauge" : "counter", metric.help);
  for (const Metric::Value& value : metric.values) {
    text += line(metric.name, metric.label.empty() ? "" : labelled(metric.label, value.label_value), value.value);
  }
  return text;
}

}  // namespace selvage::server::ops
