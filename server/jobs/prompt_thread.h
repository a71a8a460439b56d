// How soon a thread gets a processor when it wakes up and all of them are busy.
#pragma once

#include <chrono>

namespace selvage::server::jobs {

enum class Promptness {
  kFirst,  // before all others: all clients wait for it
  kSoon,   // a quick call waits for it
};

// Asks the kernel to let the calling thread run as soon as it has work, by asking for short time slices: from 6.12 on,
// Linux interrupts threads with longer ones for it, unless it has just had its share of the processor.  That share
// stays what it was.  Older kernels, and systems that forbid the call, go on as before, where it may have to wait for
// the end of another thread's slice, which takes some milliseconds.
void run_promptly(Promptness how);

// From now on the calling thread, and those that it starts, have a third of the share in a busy processor that others
// have: so these have rarely had theirs when they wake up.
void give_way();

// The length of the time slices of the thread with this id, as the kernel knows it; 0: the calling one.  Returns 0 if
// the kernel does not say, because all threads have the same.
[[nodiscard]] std::chrono::nanoseconds time_slice(int thread = 0);

}  // namespace selvage::server::jobs
