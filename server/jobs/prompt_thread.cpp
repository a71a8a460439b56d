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
using std::chrono::steady_clock;

struct Urgency {
  std::uint32_t priority;    // in real time; the highest comes first
  milliseconds share;        // in real time, of RealTimeShare::kPeriod, on two processors or more
  std::uint64_t time_slice;  // outside it, in nanoseconds; Linux accepts none below 100,000
  // In real time with RealTime::kWhenLate.  Linux wakes a thread with such a priority on another processor than the one
  // that wakes it if that has one, too.  Beside a motion or two this costs a quick change more than it gains.
  enum class When { kAlways, kLately, kOften } when;
};

Urgency urgency_of(Promptness how) {
  switch (how) {
    case Promptness::kAlarm: return {3, milliseconds{60}, 100'000, Urgency::When::kAlways};
    case Promptness::kFirst: return {3, milliseconds{60}, 100'000, Urgency::When::kLately};
    case Promptness::kSoon: return {2, milliseconds{30}, 200'000, Urgency::When::kLately};
    default: return {1, milliseconds{10}, 400'000, Urgency::When::kOften};
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

// With RealTime::kWhenLate.
bool is_time(Urgency::When when, steady_clock::time_point now) {
  switch (when) {
    case Urgency::When::kAlways: return true;
    case Urgency::When::kLately: return lateness_of_all.lately(now);
    default: return lateness_of_all.often(now);
  }
}

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
  const bool without_lateness = own_urgency->when == Urgency::When::kAlways;
  set_real_time(when == RealTime::kAlways || (when == RealTime::kWhenLate && without_lateness));
}

void woke_up_after(steady_clock::duration waited, bool (*are_short)()) {
  if (real_time_when != RealTime::kWhenLate) return;
  const auto now = steady_clock::now();
  // While a processor is idle, a late thread has not waited for another thread, so a priority would not help it.
  lateness_of_all.record(waited >= Lateness::kLate && are_short(), now);
  if (own_urgency) set_real_time(is_time(own_urgency->when, now));
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
