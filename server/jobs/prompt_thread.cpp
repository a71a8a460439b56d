#include "server/jobs/prompt_thread.h"

#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>

namespace selvage::server::jobs {
namespace {

// What sched_getattr(2) and sched_setattr(2) read and write.  glibc has neither before 2.41, and the kernel's header
// for it cannot be included together with <sched.h>.
struct Attributes {
  std::uint32_t size, policy;
  std::uint64_t flags;
  std::int32_t nice;
  std::uint32_t priority;
  std::uint64_t runtime;  // the time slice, in nanoseconds
  std::uint64_t deadline, period;
};
static_assert(sizeof(Attributes) == 48);

constexpr unsigned kNoFlags = 0;

struct Urgency {
  std::uint32_t priority;    // in real time; the highest comes first
  std::uint64_t time_slice;  // without, in nanoseconds; Linux accepts none below 100,000
};

Urgency urgency_of(Promptness how) {
  switch (how) {
    case Promptness::kFirst: return {3, 100'000};
    case Promptness::kSoon: return {2, 200'000};
    default: return {1, 400'000};
  }
}

// Returns false if the kernel refuses.
bool read(int thread, Attributes& attributes) {
  return ::syscall(SYS_sched_getattr, thread, &attributes, sizeof attributes, kNoFlags) == 0;
}

// Changes those of the calling thread.  Returns false if the kernel refuses.
template <class Change>
bool change(const Change& to) {
  constexpr int kThisThread = 0;
  Attributes attributes{};
  if (!read(kThisThread, attributes)) return false;
  to(attributes);
  return ::syscall(SYS_sched_setattr, kThisThread, &attributes, kNoFlags) == 0;
}

std::atomic<bool>& real_time() {
  static std::atomic<bool> used{false};
  return used;
}

// Returns false if the kernel refuses.
bool run_in_real_time(Promptness how) {
  constexpr std::uint64_t kNotInherited = 1;  // SCHED_FLAG_RESET_ON_FORK
  return change([how](Attributes& own) {
    own.policy = SCHED_RR;
    own.priority = urgency_of(how).priority;
    own.flags |= kNotInherited;
    own.runtime = 0;
  });
}

}  // namespace

bool use_real_time(bool wanted) {
  bool possible = !wanted;
  // A thread of its own, because this one is to keep its priority.
  if (wanted) std::jthread{[&possible] { possible = run_in_real_time(Promptness::kFirst); }}.join();
  if (possible) real_time() = wanted;
  return possible;
}

void run_promptly(Promptness how) {
  if (real_time() && run_in_real_time(how)) return;
  (void)change([how](Attributes& own) { own.runtime = urgency_of(how).time_slice; });
}

void give_way() {
  (void)change([](Attributes& own) {
    constexpr std::int32_t kLower = 5, kLowest = 19;
    own.nice = std::min(own.nice + kLower, kLowest);
  });
}

unsigned real_time_priority(int thread) {
  Attributes attributes{};
  return read(thread, attributes) ? attributes.priority : 0;
}

std::chrono::nanoseconds time_slice(int thread) {
  Attributes attributes{};
  return std::chrono::nanoseconds{read(thread, attributes) ? attributes.runtime : 0};
}

}  // namespace selvage::server::jobs
