#include "clients/cli/terminal/interrupt.h"

#include <pthread.h>
#include <signal.h>

namespace selvage::cli::terminal {
namespace {

sigset_t stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

// Little is allowed in a signal handler, so a thread waits for the signal instead.
void wait_for_signal(const std::stop_token& end, std::stop_source& requested) {
  const sigset_t set = stop_signals();
  for (;;) {
    int signal{};
    sigwait(&set, &signal);
    if (end.stop_requested()) return;
    if (requested.stop_requested()) {
      pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
      raise(signal);
    }
    requested.request_stop();
  }
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t set = stop_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  waiter_ =
      std::jthread{[requested = requested_](const std::stop_token& end) mutable { wait_for_signal(end, requested); }};
}

Interrupt::~Interrupt() {
  waiter_.request_stop();
  pthread_kill(waiter_.native_handle(), SIGINT);  // only the waiting thread receives it, and ends
  waiter_.join();
  const sigset_t set = stop_signals();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace selvage::cli::terminal
