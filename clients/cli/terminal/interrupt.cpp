#include "clients/cli/terminal/interrupt.h"

#include <pthread.h>
#include <signal.h>
#include <time.h>

namespace selvage::cli::terminal {
namespace {

sigset_t stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

// Little is allowed in a signal handler, so a thread waits for the signal instead.  It wakes up regularly to see
// whether it should end.
void wait_for_signal(const std::stop_token& end, std::stop_source& requested) {
  const sigset_t set = stop_signals();
  const timespec pause{0, 50'000'000};
  while (!end.stop_requested()) {
    const int signal = sigtimedwait(&set, nullptr, &pause);
    if (signal < 0) continue;
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
  waiter_.join();
  const sigset_t set = stop_signals();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace selvage::cli::terminal
