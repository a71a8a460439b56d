// The daemon: a backend behind a transport, with its metrics and its journal, and the order in which they start and
// end.
//
// The ports open first, so that health checks and clients reach a daemon that reports that it is loading.  Until the
// markers of the store have been loaded, calls are answered with the error -32010, over HTTP with status 503.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "protocol/methods/method_table.h"
#include "server/app/options.h"
#include "server/dispatch/backend.h"
#include "server/ops/metrics.h"
#include "server/ops/throttle.h"
#include "server/store/journal.h"
#include "server/transport/transport.h"

namespace selvage::server::app {

class Daemon {
 public:
  // Listens immediately, unless the options ask for a replay, which only uses call().  The store, if there is one, is
  // loaded by a separate thread.  Throws a std::exception if an address or a file cannot be used.
  explicit Daemon(const Options& options, protocol::methods::MethodTable methods = protocol::methods::method_table());
  ~Daemon();  // drains
  // Returns true once calls are answered, or false if the daemon was drained before that.  Throws a std::exception if
  // the store cannot be used.
  bool wait_until_loaded();
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  // The addresses it listens on, HTTP first.  REQUIRES for port(): it listens.
  [[nodiscard]] const std::vector<transport::access::Listener>& listeners() const { return transport_.listeners(); }
  [[nodiscard]] std::uint16_t port() const { return listeners().front().port; }
  // REQUIRES: it is loaded.
  [[nodiscard]] const SumCache& sums() const { return backend_->sums(); }

  // Reads the token and the TLS files again.  If one of them cannot be used, a line in the log says so and nothing is
  // replaced.
  void reload(const Options& options);

  // Stops loading, accepts nothing new, asks the running motions to return their best results, sends every answer and
  // closes all connections.
  void drain();

  // Answers a message that did not arrive over a socket.
  void call(std::string message, const std::shared_ptr<transport::access::Session>& session,
            transport::access::Reply reply);
  // The bodies of GET /readyz and GET /metrics.
  [[nodiscard]] std::string why_not_ready() const;
  [[nodiscard]] std::string metrics_text() const;

 private:
  void load(const std::stop_token& stop, const Options& options, protocol::methods::MethodTable methods);
  // Null while it is loading.
  [[nodiscard]] dispatch::Backend* backend() const { return loaded_backend_.load(); }
  [[nodiscard]] dispatch::BackendSettings backend_settings(const Options& options,
                                                           protocol::methods::MethodTable methods,
                                                           const std::stop_token& loading);
  [[nodiscard]] transport::access::Service service(const Options& options);
  void log_refusal(transport::access::Refusal refusal, const std::string& peer);

  const std::chrono::seconds drain_time_;
  const std::shared_ptr<memory::ByteAccount> traffic_;
  std::atomic<bool> draining_{};
  ops::Metrics metrics_;
  const std::shared_ptr<transport::access::TransportCounts> connections_ =
      std::make_shared<transport::access::TransportCounts>();
  std::array<ops::Throttle, transport::access::kRefusals.size()> refusals_{};  // the I/O thread's
  const ops::OnAnswered on_answered_;
  const std::size_t body_bytes_;                // of the largest message
  std::unique_ptr<store::Journal> journal_;     // null: markers live in memory only
  std::unique_ptr<dispatch::Backend> backend_;  // the loading thread's, until it is loaded
  std::atomic<dispatch::Backend*> loaded_backend_{};
  transport::Transport transport_;
  std::shared_future<void> loaded_;
  std::jthread loading_;
};

}  // namespace selvage::server::app
