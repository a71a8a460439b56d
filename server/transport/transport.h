// The daemon's doors: TCP ports and Unix sockets, with HTTP (POST /rpc, WebSocket at /ws, and pages such as /healthz)
// and newline-delimited JSON behind them.
//
// One thread does all input and output and never waits for an answer.
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "server/transport/access/listener.h"
#include "server/transport/access/service.h"

namespace selvage::server::transport {

class Transport {
 public:
  // Listens at once.  Throws a std::exception when an address cannot be taken or a TLS file not be used.
  Transport(const access::Doors& doors, const access::TransportLimits& limits, access::Service service);
  ~Transport();  // finish() without patience
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  // Where it listens, in the order given, with the ports that were taken.
  [[nodiscard]] const std::vector<access::Listener>& listeners() const;

  // Takes no new connection and reads nothing more from those there are.
  void stop_reading();
  // REQUIRES: every call has been answered, or will be.  Sends what is not sent yet, for at most `patience`;
  // then closes every connection and returns.
  void finish(std::chrono::milliseconds patience);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace selvage::server::transport
