// The queues that calls wait in, each with workers of its own.
#pragma once

#include <cstddef>

#include "server/calls/limits.h"
#include "server/jobs/job_queue.h"

namespace selvage::server::dispatch {

struct WorkQueues {
  // `workers`: for motions.  With 0, all queues are without workers and everything is executed inline.
  WorkQueues(std::size_t workers, const calls::Limits& limits);

  // Asks all jobs to stop and returns when the last one has ended.
  void drain();
  [[nodiscard]] std::size_t running() const;

  jobs::JobQueue parsing;  // of large messages, so that no read waits behind one
  jobs::JobQueue reads;
  jobs::JobQueue motions;  // and the other changes of markers
  jobs::JobQueue drags;
};

}  // namespace selvage::server::dispatch
