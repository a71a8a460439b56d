// What Prometheus' client libraries report about every process: processor time, memory, file descriptors, start.
// Source: https://prometheus.io/docs/instrumenting/writing_clientlibs/#process-metrics.
#pragma once

#include <vector>

#include "server/ops/metrics.h"

namespace selvage::server::ops {

// Read from /proc now.  What cannot be read is left out.
[[nodiscard]] std::vector<Metric> process_metrics();

}  // namespace selvage::server::ops
