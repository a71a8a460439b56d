// The queues in which calls wait, each with its own workers.
#pragma once

#include <cstddef>

#include "server/calls/limits.h"
#include "server/jobs/deadline_clock.h"
#include "server/jobs/job_queue.h"

namespace selvage::server::dispatch {

struct WorkQueues {
  // `workers`: for motions.  With 0, no queue has workers and everything is executed inline.  REQUIRES: `clock`
  // outlives the queues.
  WorkQueues(std::size_t workers, const calls::Limits& limits, const jobs::DeadlineClock& clock);

  // Asks all jobs to stop and returns when the last one has ended.
  void drain();
  [[nodiscard]] std::size_t running() const;
  // The longest time that a quick call has been waiting for a worker; 0 if none waits.
  [[nodiscard]] jobs::JobQueue::Milliseconds longest_quick_wait() const;
  // Removes the waiting calls that have been answered.
  void remove_answered();

  jobs::JobQueue parsing;  // of messages that take long to parse, so that no read waits behind one
  jobs::JobQueue reads;
  jobs::JobQueue openings;  // and closings and copies of the store: what waits for the disk, so that no read does
  jobs::JobQueue motions;   // and the other changes of markers
  jobs::JobQueue drags;
};

}  // namespace selvage::server::dispatch
