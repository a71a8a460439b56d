#include "server/jobs/real_time_share.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <utility>

namespace selvage::server::jobs {
namespace {

using std::chrono::nanoseconds;
using std::chrono::steady_clock;

int signal_of_timers() {
  return SIGRTMIN;
}

// The calling thread may have been started with all signals blocked.
void let_signal_through() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, signal_of_timers());
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

// Once it has had a priority, a thread without privileges has to keep this flag: SCHED_FLAG_RESET_ON_FORK.
constexpr std::uint64_t kNotInherited = 1;

Scheduling without_priority(Scheduling scheduling) {
  scheduling.flags |= kNotInherited;
  return scheduling;
}

Scheduling with_priority(Scheduling scheduling, unsigned priority) {
  scheduling.policy = SCHED_RR;
  scheduling.priority = priority;
  scheduling.flags |= kNotInherited;
  scheduling.runtime = 0;
  return scheduling;
}

// The share that a signal is about, even if somebody else has sent it, or its timer has been deleted meanwhile.
thread_local RealTimeShare* share_of_this_thread = nullptr;

}  // namespace

RealTimeShare::Timer::Timer(clockid_t clock) {
  sigevent event{};
  event.sigev_notify = SIGEV_THREAD_ID;
  event.sigev_signo = signal_of_timers();
  event._sigev_un._tid = ::gettid();  // glibc 2.36 has no other name for it
  exists_ = ::timer_create(clock, &event, &id_) == 0;
}

RealTimeShare::Timer::~Timer() {
  if (exists_) ::timer_delete(id_);
}

void RealTimeShare::Timer::set(nanoseconds time) const {
  time = std::max(time, nanoseconds{1});  // 0 would switch it off
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
  const itimerspec once{.it_interval = {}, .it_value = {seconds.count(), (time - seconds).count()}};
  ::timer_settime(id_, 0, &once, nullptr);
}

std::unique_ptr<RealTimeShare> RealTimeShare::begin(unsigned priority, std::chrono::milliseconds share) {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  Scheduling now{};
  if (::sigaction(signal_of_timers(), &action, nullptr) != 0 || !read_scheduling(0, now)) return nullptr;
  std::unique_ptr<RealTimeShare> begun{new RealTimeShare{now, priority, share}};
  if (!begun->work_.exists() || !begun->rest_.exists()) return nullptr;
  share_of_this_thread = begun.get();
  let_signal_through();
  begun->begin_period();
  return begun->has_priority_ ? std::move(begun) : nullptr;
}

RealTimeShare::RealTimeShare(const Scheduling& ordinary, unsigned priority, std::chrono::milliseconds share)
    : ordinary_{without_priority(ordinary)},
      in_real_time_{with_priority(ordinary, priority)},
      share_{share},
      work_{CLOCK_THREAD_CPUTIME_ID},
      rest_{CLOCK_MONOTONIC} {}

RealTimeShare::~RealTimeShare() {
  share_of_this_thread = nullptr;
  std::atomic_signal_fence(std::memory_order_seq_cst);
  if (has_priority_) (void)write_scheduling(ordinary_);
}

void RealTimeShare::on_signal(int /*signal*/) {
  if (share_of_this_thread == nullptr) return;
  const int error = errno;
  share_of_this_thread->change();
  errno = error;
}

void RealTimeShare::change() {
  // A thread that has taken longer than the period for its share begins the next one at once.
  if (has_priority_ && steady_clock::now() < period_ends_) {
    end_share();
  } else {
    begin_period();
  }
}

void RealTimeShare::begin_period() {
  period_ends_ = steady_clock::now() + kPeriod;
  work_.set(share_);
  has_priority_ = has_priority_ || write_scheduling(in_real_time_);
}

void RealTimeShare::end_share() {
  rest_.set(period_ends_ - steady_clock::now());
  has_priority_ = !write_scheduling(ordinary_);
}

}  // namespace selvage::server::jobs
