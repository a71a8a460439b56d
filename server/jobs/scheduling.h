// How the kernel schedules threads.
#pragma once

#include <cstdint>
#include <istream>

namespace selvage::server::jobs {

// glibc has no such structure before 2.41, and the kernel's header for it cannot be included together with <sched.h>.
struct Scheduling {
  std::uint32_t size, policy;
  std::uint64_t flags;
  std::int32_t nice;
  std::uint32_t priority;  // in real time, 1 to 99; 0: none
  std::uint64_t runtime;   // the time slice, in nanoseconds; 0: as long as that of others
  std::uint64_t deadline, period;
};
static_assert(sizeof(Scheduling) == 48);

// What sched_getattr(2) reads and sched_setattr(2) writes.  Signal handlers may call both functions.
//
// Reads that of the thread with this id; 0: the calling one.  Returns false if the kernel refuses.
[[nodiscard]] bool read_scheduling(int thread, Scheduling& scheduling);

// Writes that of the calling thread.  Returns false, and changes nothing, if the kernel refuses.
[[nodiscard]] bool write_scheduling(Scheduling scheduling);

// Whether more threads of the whole machine run, or could run, than there are processors for this program.  Where the
// kernel does not say, they might.
[[nodiscard]] bool processors_are_short();
// The same for what /proc/loadavg contains.
[[nodiscard]] bool processors_are_short(std::istream& load, unsigned processors);

}  // namespace selvage::server::jobs
