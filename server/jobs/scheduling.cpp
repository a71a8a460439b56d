#include "server/jobs/scheduling.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <fstream>
#include <thread>

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

bool processors_are_short() {
  std::ifstream load{"/proc/loadavg"};  // three averages, then the threads that run or could run now
  double average{};
  unsigned running{};
  const bool told = static_cast<bool>(load >> average >> average >> average >> running);
  return !told || running > std::thread::hardware_concurrency();
}

}  // namespace selvage::server::jobs
