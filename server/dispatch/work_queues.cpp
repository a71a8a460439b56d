#include "server/dispatch/work_queues.h"

#include <algorithm>

namespace selvage::server::dispatch {
namespace {

// Reads have workers of their own, so that no read waits behind a motion.  One of them is for quick reads only, so that
// no quick read waits behind a long one.  Likewise there is one more worker for quick changes only.
constexpr std::size_t kReadWorkers = 1;
constexpr jobs::QuickWorkers kQuickReads{1, jobs::Promptness::kSoon}, kQuickChanges{1, jobs::Promptness::kNext};
// Parsing has workers of its own, so that no read waits for it; one of them takes no large messages.
constexpr std::size_t kParsingWorkers = 1;
constexpr jobs::QuickWorkers kQuickParsing{1, jobs::Promptness::kNext};
// One worker takes no copies of the store, so that no opening waits behind one.
constexpr std::size_t kOpeningWorkers = 1;
constexpr jobs::QuickWorkers kQuickOpenings{1, jobs::Promptness::kNext};
// Drag sessions have at least two workers of their own, so that none waits behind a motion or one other session.
constexpr std::size_t kMinDragWorkers = 2;

jobs::JobQueue::Now time_of(const jobs::DeadlineClock& clock) {
  return [&clock] { return clock.now(); };
}

}  // namespace

WorkQueues::WorkQueues(std::size_t workers, const calls::Limits& limits, const jobs::DeadlineClock& clock)
    : parsing{workers == 0 ? 0 : kParsingWorkers, limits.waiting_reads, kQuickParsing, time_of(clock)},
      reads{workers == 0 ? 0 : kReadWorkers, limits.waiting_reads, kQuickReads, time_of(clock)},
      openings{workers == 0 ? 0 : kOpeningWorkers, limits.waiting_reads, kQuickOpenings, time_of(clock)},
      motions{workers, limits.waiting_motions, kQuickChanges, time_of(clock)},
      drags{workers == 0 ? 0 : std::max(workers, kMinDragWorkers), limits.waiting_moves, {}, time_of(clock)} {}

void WorkQueues::drain() {
  motions.drain();
  drags.drain();
  parsing.drain();
  openings.drain();
  reads.drain();
}

jobs::JobQueue::Milliseconds WorkQueues::longest_quick_wait() const {
  return std::max({motions.longest_quick_wait(), drags.longest_quick_wait(), reads.longest_quick_wait(),
                   openings.longest_quick_wait(), parsing.longest_quick_wait()});
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
