// The daemon: a backend behind a transport, with its metrics and its journal, and the order in which they end.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
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
  // Listens immediately, unless the options ask for a replay, which only uses call().  Throws a std::exception if an
  // address or a file cannot be used.
  explicit Daemon(const Options& options, protocol::methods::MethodTable methods = protocol::methods::method_table());
  ~Daemon();  // drains
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  // The addresses it listens on, HTTP first.  REQUIRES for port(): it listens.
  [[nodiscard]] const std::vector<transport::access::Listener>& listeners() const { return transport_.listeners(); }
  [[nodiscard]] std::uint16_t port() const { return listeners().front().port; }
  [[nodiscard]] const SumCache& sums() const { return backend_.sums(); }

  // Reads the token and the TLS files again.  If one of them cannot be used, a line in the log says so, and nothing is
  // replaced.
  void reload(const Options& options);

  // Accepts nothing new, asks the running motions for their best results, sends every answer and closes.
  void drain();

  // Answers a message that did not come over a socket.
  void call(std::string message, const std::shared_ptr<transport::access::Session>& session,
            transport::access::Reply reply);
  // The bodies of GET /readyz and GET /metrics.
  [[nodiscard]] std::string why_not_ready() const;
  [[nodiscard]] std::string metrics_text() const;

 private:
  [[nodiscard]] dispatch::BackendSettings backend_settings(const Options& options,
                                                           protocol::methods::MethodTable methods);
  [[nodiscard]] transport::access::Service service(const Options& options);
  void log_refusal(transport::access::Refusal refusal, const std::string& peer);

  const std::chrono::seconds drain_time_;
  const std::shared_ptr<transport::access::ByteAccount> traffic_;
  std::atomic<bool> draining_{};
  ops::Metrics metrics_;
  const std::shared_ptr<transport::access::TransportCounts> connections_ =
      std::make_shared<transport::access::TransportCounts>();
  std::array<ops::Throttle, transport::access::kRefusals.size()> refusals_{};  // the I/O thread's
  std::unique_ptr<store::Journal> journal_;                                    // null: markers live in memory only
  dispatch::Backend backend_;
  transport::Transport transport_;
};

}  // namespace selvage::server::app
