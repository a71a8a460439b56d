// How soon a thread gets a processor when it wakes up and all of them are busy.
#pragma once

#include <chrono>

#include "server/jobs/scheduling.h"

namespace selvage::server::jobs {

enum class Promptness {
  kAlarm,  // as kFirst, but it is woken by the kernel's clock instead of another thread
  kFirst,  // before all others: all clients wait for it
  kSoon,   // a quick read waits for it, which takes a fraction of a millisecond
  kNext,   // a quick change or an opening waits for it, which may take some milliseconds
};

enum class RealTime {
  kNever,
  kWhenLate,  // for some seconds after any of these threads has woken up late (lateness.h); with kNext, if they are
              // late often; with kAlarm always
  kAlways,
};

// When the threads for which run_promptly() is called from now on have real-time priorities; unless told so, never.
// Returns false, and changes nothing, if the system allows none: without the capability CAP_SYS_NICE, the limit
// RLIMIT_RTPRIO has to be 3.
[[nodiscard]] bool use_real_time(RealTime when);

// Asks the kernel to let the calling thread run as soon as it has work.
//
// With a real-time priority it interrupts at once every thread that has none, for a share of its time: of 100 ms, 60 if
// it comes first, 30 if it comes soon and 10 if it comes next, or half of that where there is one processor
// (real_time_share.h).  Threads that it starts later have none.  While processors are idle, calls are answered sooner
// without one: Linux wakes such a thread on another processor than the thread that wakes it, and an idle processor
// takes some time to wake up.
//
// Without a real-time priority, and when it has had its share, it asks for short time slices: from 6.12 on, Linux
// interrupts threads with longer ones for it, unless it has just had its share of the processor, or others wait as
// well.  Short slices do not change that share.  On older kernels, and on systems that forbid the call, it may still
// have to wait for the end of another thread's slice, which takes some milliseconds.
void run_promptly(Promptness how);

// The calling thread has woken up for work that it was given so long ago, when it waited for nothing else.  It is late
// if that took Lateness::kLate or more, while more threads wanted to run than there are processors.  With
// RealTime::kWhenLate a thread of run_promptly() gains or loses its priority here; for other threads it is only
// recorded whether they were late.  `are_short` says whether more threads want to run; tests replace it.
void woke_up_after(std::chrono::steady_clock::duration waited, bool (*are_short)() = processors_are_short);

// From now on the calling thread, and those that it starts, have a third of the share in a busy processor that others
// have, so the others have rarely used up theirs when they wake up.
void give_way();

// The real-time priority of the thread with this id, 1 or more; 0: the calling one.  Returns 0 if it has none.
[[nodiscard]] unsigned real_time_priority(int thread = 0);

// The length of the time slices of the thread with this id, as the kernel knows it; 0: the calling one.  Returns 0 if
// the kernel does not say, because all threads have the same, or because it has a real-time priority.
[[nodiscard]] std::chrono::nanoseconds time_slice(int thread = 0);

}  // namespace selvage::server::jobs
