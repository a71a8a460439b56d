#include "server/jobs/scheduling.h"

#include <sys/syscall.h>
#include <unistd.h>

namespace selvage::server::jobs {
namespace {

constexpr unsigned kNoFlags = 0;

}  // namespace

bool read_scheduling(int thread, Scheduling& scheduling) {
  return ::syscall(SYS_sched_getattr, thread, &scheduling, sizeof scheduling, kNoFlags) == 0;
}

bool write_scheduling(Scheduling scheduling) {
  constexpr int kThisThread = 0;
  return ::syscall(SYS_sched_setattr, kThisThread, &scheduling, kNoFlags) == 0;
}

}  // namespace selvage::server::jobs
