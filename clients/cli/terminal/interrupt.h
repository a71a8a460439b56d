// Turns Ctrl-C (SIGINT), and the SIGTERM of timeout and of batch systems, into a stop request.  The first signal
// requests a stop; the second ends the process as usual.
#pragma once

#include <stop_token>
#include <thread>

namespace selvage::cli::terminal {

class Interrupt {
 public:
  // Blocks both signals for the process.  REQUIRES: constructed once, before any other thread is started.
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] std::stop_token token() const { return requested_.get_token(); }

 private:
  std::stop_source requested_;
  std::jthread waiter_;
};

}  // namespace selvage::cli::terminal
