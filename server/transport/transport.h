// The daemon's door: one TCP port that speaks HTTP (POST /rpc, GET /healthz) and newline-delimited JSON, told
// apart by the first byte that is not blank: '{' or '[' begins JSON, anything else HTTP.
//
// One thread does all input and output and never waits for an answer.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "server/transport/service.h"

namespace selvage {

class Transport {
 public:
  // Listens at once.  Throws a std::exception when the address cannot be taken.
  Transport(const std::string& host, std::uint16_t port, const TransportLimits& limits, Service service);
  ~Transport();  // finish() without patience
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  [[nodiscard]] std::uint16_t port() const;

  // Takes no new connection and reads nothing more from those there are.
  void stop_reading();
  // REQUIRES: every call has been answered, or will be.  Sends what is not sent yet, for at most `patience`;
  // then closes every connection and returns.
  void finish(std::chrono::milliseconds patience);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace selvage
