#include "server/jobs/prompt_thread.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

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

// Returns false if the kernel refuses.
bool read(int thread, Attributes& attributes) {
  return ::syscall(SYS_sched_getattr, thread, &attributes, sizeof attributes, kNoFlags) == 0;
}

// Changes those of the calling thread, if the kernel allows it.
template <class Change>
void change(const Change& to) {
  constexpr int kThisThread = 0;
  Attributes attributes{};
  if (!read(kThisThread, attributes)) return;
  to(attributes);
  (void)::syscall(SYS_sched_setattr, kThisThread, &attributes, kNoFlags);
}

}  // namespace

void run_promptly(Promptness how) {
  constexpr std::uint64_t kFirst = 100'000, kSoon = 200'000;  // nanoseconds; Linux accepts none below the first
  change([how](Attributes& own) { own.runtime = how == Promptness::kFirst ? kFirst : kSoon; });
}

void give_way() {
  change([](Attributes& own) {
    constexpr std::int32_t kLower = 5, kLowest = 19;
    own.nice = std::min(own.nice + kLower, kLowest);
  });
}

std::chrono::nanoseconds time_slice(int thread) {
  Attributes attributes{};
  return std::chrono::nanoseconds{read(thread, attributes) ? attributes.runtime : 0};
}

}  // namespace selvage::server::jobs
