#include "server/app/daemon.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "server/app/authentication.h"
#include "server/methods/method_groups.h"
#include "server/ops/process_metrics.h"
#include "server/ops/version.h"
#include "server/room/room.h"
#include "server/store/disk/schema.h"

namespace selvage::server::app {
namespace {

transport::access::ListenSettings listening_for(const Options& options) {
  return options.task == Options::Task::kServe ? listen_settings(options) : transport::access::ListenSettings{};
}

// Null: markers live in memory only.
std::unique_ptr<store::Journal> open_journal(const Options& options) {
  if (options.store.empty()) return nullptr;
  try {
    return std::make_unique<store::Journal>(options.store, options.durability);
  } catch (const store::disk::NewerStore& error) {
    throw store::disk::NewerStore{"--store " + options.store + ": " + error.what()};
  } catch (const std::exception& error) {
    throw std::runtime_error{"--store " + options.store + ": " + error.what()};
  }
}

}  // namespace

Daemon::Daemon(const Options& options, protocol::methods::MethodTable methods)
    : drain_time_{options.drain},
      traffic_{std::make_shared<transport::access::ByteAccount>(options.limits.transport.traffic_bytes)},
      journal_{open_journal(options)},
      backend_{backend_settings(options, std::move(methods))},
      transport_{listening_for(options), options.limits.transport, service(options)} {}

dispatch::BackendSettings Daemon::backend_settings(const Options& options, protocol::methods::MethodTable methods) {
  return {.workers = options.workers,
          .cache_bytes = options.cache_mb << 20,
          .limits = options.limits,
          .journal = journal_.get(),
          .methods = std::move(methods),
          .on_answered = [this](const ops::AnsweredRequest& request) {
            metrics_.count(request);
            log_request(request);
          }};
}

transport::access::Service Daemon::service(const Options& options) {
  return {
      .call = [this](std::string message, const std::shared_ptr<transport::access::Session>& session,
                     transport::access::Reply reply) { call(std::move(message), session, std::move(reply)); },
      .health = [] { return std::string{"{\"status\":\"ok\"}"}; },
      .ready = [this] { return why_not_ready(); },
      .metrics = [this] { return metrics_text(); },
      .openrpc = server::methods::openrpc_text,
      .file = room::find_file,
      .authenticate = authenticate_first_message,
      .on_refused = [this](transport::access::Refusal refusal, const std::string& peer) { log_refusal(refusal, peer); },
      .line_too_long = dispatch::Dispatcher::too_long(options.limits.transport.body_bytes),
      .no_room = dispatch::error_text({protocol::rpc::RpcCode::kLimit,
                                       "too many bytes of requests and answers are in progress; try again later",
                                       Json{{"limit", traffic_->limit()}}}),
      .account = traffic_,
      .counts = connections_};
}

void Daemon::call(std::string message, const std::shared_ptr<transport::access::Session>& session,
                  transport::access::Reply reply) {
  backend_.receive(std::move(message), session, std::move(reply));
}

void Daemon::log_refusal(transport::access::Refusal refusal, const std::string& peer) {
  const auto withheld = refusals_.at(static_cast<std::size_t>(refusal)).pass(std::chrono::steady_clock::now());
  if (withheld) ops::log_refusal({.reason = name_of(refusal), .peer = peer, .withheld = *withheld});
}

std::string Daemon::why_not_ready() const {
  if (draining_) return "shutting down";
  return backend_.why_not_ready();
}

std::string Daemon::metrics_text() const {
  const auto value = [](auto count) { return static_cast<double>(count); };
  const minkowski::CacheCounts sums = backend_.sums().counts();
  const dispatch::WorkQueues& queues = backend_.queues();
  const transport::access::TransportCounts& open = *connections_;
  using enum ops::Metric::Type;
  const std::array kNow{
      ops::Metric{"selvage_open_markers", kGauge, "Open markers.", "", {{"", value(backend_.store().count())}}},
      ops::Metric{"selvage_quarantined_markers",
                  kGauge,
                  "Markers that are damaged in the store and can only be closed.",
                  "",
                  {{"", value(backend_.store().quarantined())}}},
      ops::Metric{"selvage_open_calls", kGauge, "Calls in progress.", "", {{"", value(backend_.open_calls())}}},
      ops::Metric{"selvage_jobs_waiting",
                  kGauge,
                  "Jobs that wait in a queue.",
                  "queue",
                  {{"motions", value(queues.motions.waiting())},
                   {"parsing", value(queues.parsing.waiting())},
                   {"reads", value(queues.reads.waiting())},
                   {"hands", value(queues.drags.waiting())}}},
      ops::Metric{"selvage_jobs_running",
                  kGauge,
                  "Jobs that workers execute.",
                  "queue",
                  {{"motions", value(queues.motions.running())},
                   {"parsing", value(queues.parsing.running())},
                   {"reads", value(queues.reads.running())},
                   {"hands", value(queues.drags.running())}}},
      ops::Metric{"selvage_traffic_bytes",
                  kGauge,
                  "Requests that are received or answered, and answers not yet sent.",
                  "",
                  {{"", value(traffic_->held())}}},
      ops::Metric{"selvage_open_connections",
                  kGauge,
                  "Open connections, by protocol.",
                  "speaks",
                  {{"http", value(open.http.load())},
                   {"lines", value(open.lines.load())},
                   {"websocket", value(open.websockets.load())}}},
      ops::Metric{"selvage_connections_total",
                  kCounter,
                  "Connections since the start, by whether they were accepted.",
                  "outcome",
                  {{"accepted", value(open.accepted.load())}, {"turned_away", value(open.turned_away.load())}}},
      ops::Metric{"selvage_log_lines_dropped_total",
                  kCounter,
                  "Lines of the log that could not be written, or not soon enough.",
                  "",
                  {{"", value(ops::dropped_log_lines())}}},
      ops::Metric{"selvage_sums_total",
                  kCounter,
                  "Minkowski sums requested, by whether the cache had them.",
                  "outcome",
                  {{"hit", value(sums.hits)}, {"miss", value(sums.misses)}}},
      ops::Metric{"selvage_sums_bytes", kGauge, "Memory of the cached sums.", "", {{"", value(sums.bytes)}}},
  };
  ops::Metric refused{
      "selvage_refused_total", kCounter, "Connections and requests refused because of their caller.", "reason", {}};
  for (std::size_t k = 0; k < open.refused.size(); ++k) {
    refused.values.push_back({transport::access::kRefusals.at(k), value(open.refused.at(k).load())});
  }
  std::string text = metrics_.text() + metric_text(refused);
  text += ops::metric_text(
      {"selvage_build_info", kGauge, "The version of the program; always 1.", "version", {{ops::kVersion, 1}}});
  for (const ops::Metric& metric : ops::process_metrics()) text += metric_text(metric);
  for (const ops::Metric& metric : kNow) text += metric_text(metric);
  return text;
}

Daemon::~Daemon() {
  drain();
}

void Daemon::reload(const Options& options) {
  if (options.token_file.empty() && !options.tls) return;
  try {
    transport_.reload(options.token_file.empty() ? std::string{} : read_token(options.token_file), options.tls);
    spdlog::info("the token and the certificate have been read again");
  } catch (const std::exception& error) {
    spdlog::error("the token and the certificate in use are kept: {}", error.what());
  }
}

void Daemon::drain() {
  draining_ = true;
  transport_.stop_reading();
  backend_.queues().drain();
  transport_.finish(drain_time_);
}

}  // namespace selvage::server::app
