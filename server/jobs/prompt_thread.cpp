#include "server/jobs/prompt_thread.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>

#include "server/jobs/lateness.h"
#include "server/jobs/real_time_share.h"
#include "server/jobs/scheduling.h"

namespace selvage::server::jobs {
namespace {

using std::chrono::milliseconds;

struct Urgency {
  std::uint32_t priority;    // in real time; the highest comes first
  milliseconds share;        // in real time, of RealTimeShare::kPeriod, on two processors or more
  std::uint64_t time_slice;  // outside it, in nanoseconds; Linux accepts none below 100,000
  bool before_it_is_late{};  // in real time also with RealTime::kWhenLate
};

Urgency urgency_of(Promptness how) {
  switch (how) {
    case Promptness::kAlarm: return {3, milliseconds{60}, 100'000, true};
    case Promptness::kFirst: return {3, milliseconds{60}, 100'000};
    case Promptness::kSoon: return {2, milliseconds{30}, 200'000};
    default: return {1, milliseconds{10}, 400'000};
  }
}

milliseconds share_of(const Urgency& urgency) {
  return std::thread::hardware_concurrency() == 1 ? urgency.share / 2 : urgency.share;
}

// Changes how the calling thread is scheduled, unless the kernel refuses.
template <class Change>
void change(const Change& to) {
  Scheduling own{};
  if (!read_scheduling(0, own)) return;
  to(own);
  (void)write_scheduling(own);
}

// Of all threads of the process.
std::atomic<RealTime> real_time_when{RealTime::kNever};
Lateness lateness_of_all;

// Of the calling thread.
thread_local std::optional<Urgency> own_urgency;  // none: it is not a prompt thread
thread_local std::unique_ptr<RealTimeShare> own_share;

void set_real_time(bool wanted) {
  if (!wanted) {
    own_share.reset();
  } else if (!own_share) {
    own_share = RealTimeShare::begin(own_urgency->priority, share_of(*own_urgency));
  }
}

}  // namespace

bool use_real_time(RealTime when) {
  bool possible = when == RealTime::kNever;
  // A thread of its own, because this one is to keep its priority.
  if (!possible) {
    std::jthread{[&possible] {
      const Urgency first = urgency_of(Promptness::kFirst);
      possible = RealTimeShare::begin(first.priority, first.share) != nullptr;
    }}.join();
  }
  if (possible) real_time_when = when;
  return possible;
}

void run_promptly(Promptness how) {
  set_real_time(false);
  own_urgency = urgency_of(how);
  change([](Scheduling& own) { own.runtime = own_urgency->time_slice; });
  const RealTime when = real_time_when;
  set_real_time(when == RealTime::kAlways || (when == RealTime::kWhenLate && own_urgency->before_it_is_late));
}

void woke_up_after(std::chrono::steady_clock::duration waited) {
  if (real_time_when != RealTime::kWhenLate) return;
  const auto now = std::chrono::steady_clock::now();
  lateness_of_all.record(waited, now);
  if (own_urgency) set_real_time(own_urgency->before_it_is_late || lateness_of_all.lately(now));
}

void give_way() {
  change([](Scheduling& own) {
    constexpr std::int32_t kLower = 5, kLowest = 19;
    own.nice = std::min(own.nice + kLower, kLowest);
  });
}

unsigned real_time_priority(int thread) {
  Scheduling found{};
  return read_scheduling(thread, found) ? found.priority : 0;
}

std::chrono::nanoseconds time_slice(int thread) {
  Scheduling found{};
  return std::chrono::nanoseconds{read_scheduling(thread, found) ? found.runtime : 0};
}

}  // namespace selvage::server::jobs
