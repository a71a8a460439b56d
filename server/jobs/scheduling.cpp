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
  std::ifstream load{"/proc/loadavg"};
  return processors_are_short(load, std::thread::hardware_concurrency());
}

bool processors_are_short(std::istream& load, unsigned processors) {
  double average{};
  unsigned running{};
  // Three averages, then the threads that run or could run now.
  const bool told = static_cast<bool>(load >> average >> average >> average >> running);
  return !told || running > processors;
}

}  // namespace selvage::server::jobs
