#include "clients/cli/terminal/interrupt.h"

#include <pthread.h>
#include <signal.h>
#include <time.h>

namespace selvage::cli::terminal {
namespace {

sigset_t only_sigint() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  return set;
}

// Little is allowed in a signal handler, so a thread waits for the signal instead.  It wakes up regularly to see
// whether it should end.
void wait_for_sigint(const std::stop_token& end, std::stop_source& requested) {
  const sigset_t set = only_sigint();
  const timespec pause{0, 50'000'000};
  while (!end.stop_requested()) {
    if (sigtimedwait(&set, nullptr, &pause) != SIGINT) continue;
    if (requested.stop_requested()) {
      pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
      raise(SIGINT);
    }
    requested.request_stop();
  }
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t set = only_sigint();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  waiter_ =
      std::jthread{[requested = requested_](const std::stop_token& end) mutable { wait_for_sigint(end, requested); }};
}

Interrupt::~Interrupt() {
  waiter_.request_stop();
  waiter_.join();
  const sigset_t set = only_sigint();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace selvage::cli::terminal
