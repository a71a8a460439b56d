// The body of GET /metrics.
#include <array>
#include <string>
#include <vector>

#include "server/app/daemon.h"
#include "server/ops/process_metrics.h"
#include "server/ops/version.h"

namespace selvage::server::app {
namespace {

using enum ops::Metric::Type;

template <class Count>
double value(Count count) {
  return static_cast<double>(count);
}

ops::Metric by_queue(const char* name, const char* help, const dispatch::WorkQueues& queues,
                     std::size_t (jobs::JobQueue::*count)() const) {
  return {name,
          kGauge,
          help,
          "queue",
          {{"motions", value((queues.motions.*count)())},
           {"parsing", value((queues.parsing.*count)())},
           {"reads", value((queues.reads.*count)())},
           {"openings", value((queues.openings.*count)())},
           {"drags", value((queues.drags.*count)())}}};
}

std::vector<ops::Metric> backend_metrics(const dispatch::Backend& backend) {
  const minkowski::CacheCounts sums = backend.sums().counts();
  const store::MarkerStore& store = backend.store();
  return {
      {"selvage_open_markers", kGauge, "Open markers.", "", {{"", value(store.count())}}},
      {"selvage_quarantined_markers",
       kGauge,
       "Markers that are damaged in the store and can only be closed.",
       "",
       {{"", value(store.quarantined())}}},
      {"selvage_open_calls", kGauge, "Calls in progress.", "", {{"", value(backend.open_calls())}}},
      by_queue("selvage_jobs_waiting", "Jobs that wait in a queue.", backend.queues(), &jobs::JobQueue::waiting),
      by_queue("selvage_jobs_running", "Jobs that workers are executing.", backend.queues(), &jobs::JobQueue::running),
      {"selvage_markers_bytes",
       kGauge,
       "Memory of the markers, their histories and the answers kept for retries.",
       "",
       {{"", value(store.room().account->held())}}},
      {"selvage_sums_total",
       kCounter,
       "Minkowski sums requested, by whether they were in the cache.",
       "outcome",
       {{"hit", value(sums.hits)}, {"miss", value(sums.misses)}}},
      {"selvage_sums_bytes", kGauge, "Memory of the cached sums.", "", {{"", value(sums.bytes)}}},
  };
}

std::vector<ops::Metric> store_metrics(const store::Journal& journal) {
  const store::WriteCounts writes = journal.writes();
  return {{"selvage_store_writes_total",
           kCounter,
           "Transactions of the store, by outcome.",
           "outcome",
           {{"written", value(writes.written)}, {"failed", value(writes.failed)}}},
          {"selvage_store_write_seconds_total",
           kCounter,
           "Time spent in transactions of the store.",
           "",
           {{"", writes.seconds}}},
          {"selvage_store_writable",
           kGauge,
           "0 if the last write failed or the file has been deleted or replaced; the daemon is then not ready.",
           "",
           {{"", journal.failure().empty() ? 1.0 : 0.0}}}};
}

std::vector<ops::Metric> connection_metrics(const transport::access::TransportCounts& open) {
  std::vector<ops::Metric> all{
      {"selvage_open_connections",
       kGauge,
       "Open connections, by protocol.",
       "speaks",
       {{"http", value(open.http.load())},
        {"lines", value(open.lines.load())},
        {"websocket", value(open.websockets.load())}}},
      {"selvage_connections_total",
       kCounter,
       "Connections since the start, by whether they were accepted.",
       "outcome",
       {{"accepted", value(open.accepted.load())}, {"turned_away", value(open.turned_away.load())}}},
      {"selvage_refused_total",
       kCounter,
       "Connections and requests refused because of the caller, by reason.",
       "reason",
       {}}};
  for (std::size_t k = 0; k < open.refused.size(); ++k) {
    all.back().values.push_back({transport::access::kRefusals.at(k), value(open.refused.at(k).load())});
  }
  return all;
}

}  // namespace

std::string Daemon::metrics_text() const {
  std::vector<ops::Metric> all = connection_metrics(*connections_);
  all.push_back(
      {"selvage_build_info", kGauge, "The version of the program; always 1.", "version", {{ops::kVersion, 1}}});
  all.push_back({"selvage_traffic_bytes",
                 kGauge,
                 "Requests being received or answered, the memory to answer them, and answers not yet sent.",
                 "",
                 {{"", value(traffic_->held())}}});
  all.push_back({"selvage_log_lines_dropped_total",
                 kCounter,
                 "Log lines dropped because they could not be written, or not quickly enough.",
                 "",
                 {{"", value(ops::dropped_log_lines())}}});
  std::string text = metrics_.text();
  for (const ops::Metric& metric : all) text += metric_text(metric);
  for (const ops::Metric& metric : ops::process_metrics()) text += metric_text(metric);
  if (const dispatch::Backend* const ready = backend()) {
    for (const ops::Metric& metric : backend_metrics(*ready)) text += metric_text(metric);
    if (journal_) {
      for (const ops::Metric& metric : store_metrics(*journal_)) text += metric_text(metric);
    }
  }
  return text;
}

}  // namespace selvage::server::app
