#include "server/ops/metrics.h"

#include <gtest/gtest.h>

#include <string>

namespace selvage::server::ops {
namespace {

bool has_line(const std::string& text, const std::string& line) {
  return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

TEST(Metrics, CountAnswersByMethodAndOutcome) {
  Metrics metrics;
  metrics.count({.method = "marker.get", .milliseconds = 0.2});
  metrics.count({.method = "marker.get", .milliseconds = 0.2});
  metrics.count({.method = "marker.get", .milliseconds = 0.2, .code = -32012});
  const std::string text = metrics.text();
  EXPECT_TRUE(has_line(text, "# TYPE selvage_calls_total counter"));
  EXPECT_TRUE(has_line(text, R"(selvage_calls_total{method="marker.get",code="0"} 2)")) << text;
  EXPECT_TRUE(has_line(text, R"(selvage_calls_total{method="marker.get",code="-32012"} 1)")) << text;
}

TEST(Metrics, HistogramsAreCumulative) {
  Metrics metrics;
  for (const double milliseconds : {0.3, 2.0, 50.0, 1e6}) {
    metrics.count({.method = "motion.compact", .milliseconds = milliseconds});
  }
  const std::string text = metrics.text();
  const std::string start = "selvage_call_duration_seconds";
  const auto bucket = [&](const std::string& bound, int count) {
    return has_line(text, start + R"(_bucket{method="motion.compact",le=")" + bound + "\"} " + std::to_string(count));
  };
  EXPECT_TRUE(bucket("0.0003", 1)) << text;  // a value on the bound belongs to the bucket
  EXPECT_TRUE(bucket("0.001", 1));
  EXPECT_TRUE(bucket("0.003", 2));
  EXPECT_TRUE(bucket("0.1", 3));
  EXPECT_TRUE(bucket("30", 3));
  EXPECT_TRUE(bucket("+Inf", 4));
  EXPECT_TRUE(has_line(text, start + R"(_count{method="motion.compact"} 4)"));
  EXPECT_TRUE(has_line(text, start + R"(_sum{method="motion.compact"} 1000.0523)")) << text;
}

TEST(Metrics, ClientsCannotCreateLabels) {
  Metrics metrics;
  metrics.count({.method = "no.such.method", .code = -32601});
  metrics.count({.method = "x\"} 1\nforged 2", .code = -32601});
  metrics.count({.method = "x\"} 1\nforged 2"});
  const std::string text = metrics.text();
  EXPECT_TRUE(has_line(text, R"(selvage_calls_total{method="unknown",code="-32601"} 2)")) << text;
  EXPECT_EQ(text.find("no.such"), std::string::npos);
  EXPECT_EQ(text.find("forged"), std::string::npos);
}

TEST(Metrics, CurrentValuesAreWritten) {
  EXPECT_EQ(metric_text({"markers", Metric::Type::kGauge, "Open.", "", {{"", 3}}}),
            "# HELP markers Open.\n# TYPE markers gauge\nmarkers 3\n");
  EXPECT_EQ(metric_text({"c", Metric::Type::kCounter, "Came.", "how", {{"in", 1}, {"out", 2.5}}}),
            "# HELP c Came.\n# TYPE c counter\nc{how=\"in\"} 1\nc{how=\"out\"} 2.5\n");
}

}  // namespace
}  // namespace selvage::server::ops
