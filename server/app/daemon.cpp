#include "server/app/daemon.h"

#include <spdlog/spdlog.h>

#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "server/app/authentication.h"
#include "server/jobs/prompt_thread.h"
#include "server/memory/weights.h"
#include "server/methods/method_groups.h"
#include "server/room/room.h"
#include "server/store/disk/schema.h"

namespace selvage::server::app {
namespace {

transport::access::ListenSettings listening_for(const Options& options) {
  return options.task == Options::Task::kServe ? listen_settings(options) : transport::access::ListenSettings{};
}

// Null: markers live in memory only.
std::unique_ptr<store::Journal> open_journal(const Options& options, const std::stop_token& stop) {
  if (options.store.empty()) return nullptr;
  try {
    return std::make_unique<store::Journal>(options.store, options.durability, stop);
  } catch (const store::disk::NewerStore& error) {
    throw store::disk::NewerStore{"--store " + options.store + ": " + error.what()};
  } catch (const std::exception& error) {
    throw std::runtime_error{"--store " + options.store + ": " + error.what()};
  }
}

}  // namespace

Daemon::Daemon(const Options& options, protocol::methods::MethodTable methods)
    : drain_time_{options.drain},
      traffic_{std::make_shared<memory::ByteAccount>(options.limits.transport.traffic_bytes)},
      on_answered_{[this](const ops::AnsweredRequest& request) {
        metrics_.count(request);
        log_request(request);
      }},
      body_bytes_{options.limits.transport.body_bytes},
      transport_{listening_for(options), options.limits.transport, service(options)} {
  std::packaged_task<void(std::stop_token)> loading{
      [this, options, held = std::move(methods)](const std::stop_token& stop) mutable {
        load(stop, options, std::move(held));
      }};
  loaded_ = loading.get_future().share();
  loading_ = std::jthread{std::move(loading)};
  if (options.store.empty()) loaded_.get();
}

void Daemon::load(const std::stop_token& stop, const Options& options, protocol::methods::MethodTable methods) {
  jobs::give_way();  // and so do the threads of the backend, which are started here, to the I/O thread
  try {
    journal_ = open_journal(options, stop);
    backend_ = std::make_unique<dispatch::Backend>(backend_settings(options, std::move(methods), stop));
    loaded_backend_ = backend_.get();
  } catch (const std::exception&) {
    if (!stop.stop_requested()) throw;
  }
}

bool Daemon::wait_until_loaded() {
  loaded_.get();
  return backend() != nullptr;
}

dispatch::BackendSettings Daemon::backend_settings(const Options& options, protocol::methods::MethodTable methods,
                                                   const std::stop_token& loading) {
  return {.workers = options.workers,
          .cache_bytes = options.cache_bytes,
          .limits = options.limits,
          .journal = journal_.get(),
          .loading = loading,
          .methods = std::move(methods),
          .on_answered = on_answered_};
}

transport::access::Service Daemon::service(const Options& options) {
  return {
      .call = [this](std::string message, const std::shared_ptr<transport::access::Session>& session,
                     transport::access::Reply reply) { call(std::move(message), session, std::move(reply)); },
      .weigh = memory::bytes_to_read,
      .loading = [this] { return backend() == nullptr; },
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
  if (dispatch::Backend* const ready = backend()) return ready->receive(std::move(message), session, std::move(reply));
  constexpr int kRetryMs = 500;
  reply(dispatch::refusal_text(
      message, body_bytes_, session,
      {protocol::rpc::RpcCode::kBusy, "the server is loading its markers", Json{{"retryAfterMs", kRetryMs}}},
      on_answered_));
}

void Daemon::log_refusal(transport::access::Refusal refusal, const std::string& peer) {
  const auto withheld = refusals_.at(static_cast<std::size_t>(refusal)).pass(std::chrono::steady_clock::now());
  if (withheld) ops::log_refusal({.reason = name_of(refusal), .peer = peer, .withheld = *withheld});
}

std::string Daemon::why_not_ready() const {
  if (draining_) return "shutting down";
  const dispatch::Backend* const ready = backend();
  return ready ? ready->why_not_ready() : "loading the markers of the store";
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
  loading_.request_stop();
  if (loading_.joinable()) loading_.join();
  if (backend_) backend_->queues().drain();
  transport_.finish(drain_time_);
}

}  // namespace selvage::server::app
