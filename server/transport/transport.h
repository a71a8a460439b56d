// The daemon's endpoints: TCP ports and Unix sockets that speak HTTP (POST /rpc, WebSocket at /ws, and pages such as
// /healthz) and newline-delimited JSON.
//
// One thread does all input and output and never waits for an answer.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/transport/access/listener.h"
#include "server/transport/access/service.h"

namespace selvage::server::transport {

class Transport {
 public:
  // Listens immediately.  Throws a std::exception if an address or a TLS file cannot be used.
  Transport(const access::ListenSettings& settings, const access::TransportLimits& limits, access::Service service);
  ~Transport();  // finish() without waiting
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  // The listeners in the order given, with their actual ports.
  [[nodiscard]] const std::vector<access::Listener>& listeners() const;

  // Replaces the token and the TLS files for all later requests and connections; a line connection or a WebSocket that
  // has authenticated stays open.  REQUIRES: there was a token, or this one is empty; the same for TLS.  Throws a
  // std::exception if a file cannot be used; then nothing is replaced.
  void reload(const std::string& token, const std::optional<access::TlsFiles>& tls);
  // Accepts no new connections and reads nothing more from the open ones.
  void stop_reading();
  // Sends all unsent answers, for at most `time`, then closes every connection and returns.  REQUIRES: every call has
  // been answered, or will be.
  void finish(std::chrono::milliseconds time);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace selvage::server::transport
