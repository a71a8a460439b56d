#include "server/app/daemon.h"

#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "server/app/entry.h"

namespace selvage::server::app {
namespace {

// Reads have their own workers, so that none waits behind a motion; one of them is for quick reads only, so that none
// of these waits behind a long one.  Likewise one more worker is for quick changes only.
constexpr std::size_t kReadWorkers = 1, kQuickReadWorkers = 1, kStepWorkers = 1;
// Nor does a dragging hand wait, or one hand for another.
constexpr std::size_t kLeastHandWorkers = 2, kParsingWorkers = 1;

transport::access::Doors doors_for(const Options& options) {
  return options.task == Options::Task::kServe ? doors_of(options) : transport::access::Doors{};
}

// Null: markers live in memory only.
std::unique_ptr<store::Journal> open_journal(const Options& options) {
  if (options.store.empty()) return nullptr;
  try {
    return std::make_unique<store::Journal>(options.store, options.durability);
  } catch (const std::exception& error) {
    throw std::runtime_error{"--store " + options.store + ": " + error.what()};
  }
}

}  // namespace

Daemon::Daemon(const Options& options, protocol::calls::Engine engine)
    : drain_patience_{options.drain},
      sums_{options.cache_mb << 20},
      journal_{open_journal(options)},
      store_{options.limits.open_markers, journal_.get()},
      executor_{std::max<std::size_t>(options.workers, 1) - 1,
                [this, cores = options.workers] { return idle_cores(cores); }},
      methods_{store_, watchers_, sums_, options.limits, options.workers, std::move(engine), executor_},
      parsing_{options.workers == 0 ? 0 : kParsingWorkers, options.limits.waiting_reads},
      reads_{options.workers == 0 ? 0 : kReadWorkers, options.limits.waiting_reads, kQuickReadWorkers},
      motions_{options.workers, options.limits.waiting_motions, kStepWorkers},
      hands_{options.workers == 0 ? 0 : std::max(options.workers, kLeastHandWorkers), options.limits.waiting_moves},
      drags_{store_, methods_, sums_, hands_},
      dispatcher_{methods_,
                  drags_,
                  clock_,
                  parsing_,
                  reads_,
                  motions_,
                  options.limits,
                  [this](const ops::AnsweredRequest& request) {
                    metrics_.count(request);
                    log_request(request);
                  }},
      transport_{doors_for(options), options.limits.transport, service(options)} {}

transport::access::Service Daemon::service(const Options& options) {
  return {.call = [this](std::string message, const std::shared_ptr<transport::access::Session>& session,
                         transport::access::Reply reply) { call(std::move(message), session, std::move(reply)); },
          .health = [] { return std::string{"{\"status\":\"ok\"}"}; },
          .ready = [this] { return why_not_ready(); },
          .metrics = [this] { return metrics_text(); },
          .openrpc = methods::openrpc_text,
          .enter = judge_first_message,
          .line_too_long = dispatch::Dispatcher::too_long(options.limits.transport.body_bytes),
          .counts = connections_};
}

std::size_t Daemon::idle_cores(std::size_t cores) const {
  const std::size_t busy = motions_.running() + hands_.running() + reads_.running() + parsing_.running();
  return cores - std::min(cores, busy);
}

void Daemon::call(std::string message, const std::shared_ptr<transport::access::Session>& session,
                  transport::access::Reply reply) {
  dispatcher_.receive(std::move(message), session, std::move(reply));
}

std::string Daemon::why_not_ready() const {
  if (draining_) return "going down";
  if (motions_.waiting() >= motions_.capacity()) return "the queue of motions is full";
  if (reads_.waiting() >= reads_.capacity()) return "the queue of reads is full";
  return {};
}

std::string Daemon::metrics_text() const {
  const auto value = [](auto count) { return static_cast<double>(count); };
  const minkowski::CacheCounts sums = sums_.counts();
  const transport::access::TransportCounts& open = *connections_;
  using enum ops::Metric::Type;
  const std::array kNow{
      ops::Metric{"selvage_open_markers", kGauge, "Markers that are open.", "", {{"", value(store_.count())}}},
      ops::Metric{"selvage_open_calls", kGauge, "Calls under way.", "", {{"", value(dispatcher_.open_calls())}}},
      ops::Metric{"selvage_jobs_waiting",
                  kGauge,
                  "Jobs in the queues.",
                  "queue",
                  {{"motions", value(motions_.waiting())},
                   {"parsing", value(parsing_.waiting())},
                   {"reads", value(reads_.waiting())},
                   {"hands", value(hands_.waiting())}}},
      ops::Metric{"selvage_jobs_running",
                  kGauge,
                  "Jobs on the workers.",
                  "queue",
                  {{"motions", value(motions_.running())},
                   {"parsing", value(parsing_.running())},
                   {"reads", value(reads_.running())},
                   {"hands", value(hands_.running())}}},
      ops::Metric{"selvage_connections",
                  kGauge,
                  "Connections that are open, by what is spoken on them.",
                  "speaks",
                  {{"http", value(open.http.load())},
                   {"lines", value(open.lines.load())},
                   {"websocket", value(open.websockets.load())}}},
      ops::Metric{"selvage_connections_total",
                  kCounter,
                  "Connections that came, by whether there was room.",
                  "outcome",
                  {{"accepted", value(open.accepted.load())}, {"turned_away", value(open.turned_away.load())}}},
      ops::Metric{"selvage_sums_total",
                  kCounter,
                  "Minkowski sums asked for, by whether they were kept from before.",
                  "outcome",
                  {{"hit", value(sums.hits)}, {"miss", value(sums.misses)}}},
      ops::Metric{"selvage_sums_bytes", kGauge, "Memory of the sums that are kept.", "", {{"", value(sums.bytes)}}},
  };
  std::string text = metrics_.text();
  for (const ops::Metric& metric : kNow) text += metric_text(metric);
  return text;
}

Daemon::~Daemon() {
  drain();
}

void Daemon::drain() {
  draining_ = true;
  transport_.stop_reading();
  motions_.drain();
  hands_.drain();
  parsing_.drain();
  reads_.drain();
  transport_.finish(drain_patience_);
}

}  // namespace selvage::server::app
