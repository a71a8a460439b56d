#include "server/dispatch/work_queues.h"

#include <algorithm>

namespace selvage::server::dispatch {
namespace {

constexpr std::size_t kParsingWorkers = 1;
// Reads have workers of their own, so that no read waits behind a motion.  One of them is for quick reads only, so that
// no quick read waits behind a long one.  Likewise there is one more worker for quick changes only.
constexpr std::size_t kReadWorkers = 1, kQuickReadWorkers = 1, kQuickChangeWorkers = 1;
// Nor does an opening wait behind a copy of the store.
constexpr std::size_t kOpeningWorkers = 1, kQuickOpeningWorkers = 1;
// Nor does a drag session wait behind a motion, or behind one other session.
constexpr std::size_t kMinDragWorkers = 2;

jobs::JobQueue::Now time_of(const jobs::DeadlineClock& clock) {
  return [&clock] { return clock.now(); };
}

}  // namespace

WorkQueues::WorkQueues(std::size_t workers, const calls::Limits& limits, const jobs::DeadlineClock& clock)
    : parsing{workers == 0 ? 0 : kParsingWorkers, limits.waiting_reads, 0, time_of(clock)},
      reads{workers == 0 ? 0 : kReadWorkers, limits.waiting_reads, kQuickReadWorkers, time_of(clock)},
      openings{workers == 0 ? 0 : kOpeningWorkers, limits.waiting_reads, kQuickOpeningWorkers, time_of(clock)},
      motions{workers, limits.waiting_motions, kQuickChangeWorkers, time_of(clock)},
      drags{workers == 0 ? 0 : std::max(workers, kMinDragWorkers), limits.waiting_moves, 0, time_of(clock)} {}

void WorkQueues::drain() {
  motions.drain();
  drags.drain();
  parsing.drain();
  openings.drain();
  reads.drain();
}

jobs::JobQueue::Milliseconds WorkQueues::longest_quick_wait() const {
  return std::max({motions.longest_quick_wait(), drags.longest_quick_wait(), reads.longest_quick_wait(),
                   openings.longest_quick_wait()});
}

void WorkQueues::remove_answered() {
  motions.remove_answered();
  reads.remove_answered();
  openings.remove_answered();
}

std::size_t WorkQueues::running() const {
  return motions.running() + drags.running() + reads.running() + openings.running() + parsing.running();
}

}  // namespace selvage::server::dispatch
