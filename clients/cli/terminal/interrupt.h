// Ctrl-C as a stop request.  The first asks whoever holds the token to stop; a second one ends the process as
// usual.
#pragma once

#include <stop_token>
#include <thread>

namespace selvage::cli::terminal {

class Interrupt {
 public:
  // From here on SIGINT is ours.  REQUIRES: made before any other thread is started, and once.
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
