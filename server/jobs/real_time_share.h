// A real-time priority that a thread has for a part of its time.
//
// A thread with such a priority interrupts every thread that has none, so one whose work does not end, or that a flood
// of calls keeps busy, would take a processor from everything else on the machine.  Here it has the priority until it
// has worked for its share of a period of 100 ms, and is then an ordinary thread until the period ends, also in the
// middle of its work.
//
// The kernel does the accounting: a timer for the thread's processor time, or for the end of the period, sends the
// thread a signal (SIGRTMIN).  A thread that works less than its share is hardly ever interrupted.  The kernel looks at
// processor times when its clock ticks, every 1 to 10 ms, so a share may last that much longer.
#pragma once

#include <chrono>
#include <ctime>
#include <memory>

#include "server/jobs/scheduling.h"

namespace selvage::server::jobs {

class RealTimeShare {
 public:
  static constexpr std::chrono::milliseconds kPeriod{100};

  // Gives the priority to the calling thread, from now on; outside its share it is scheduled as it is now.  Threads
  // that it starts have no such priority.  Returns null, and changes nothing, if the kernel refuses the priority or a
  // timer.
  // REQUIRES: destroyed on the same thread, which takes the priority away.
  [[nodiscard]] static std::unique_ptr<RealTimeShare> begin(unsigned priority, std::chrono::milliseconds share);

  ~RealTimeShare();
  RealTimeShare(const RealTimeShare&) = delete;
  RealTimeShare& operator=(const RealTimeShare&) = delete;

 private:
  // Sends the signal to the thread that created it, once, when a time of `clock` has passed.
  class Timer {
   public:
    explicit Timer(clockid_t clock);
    ~Timer();
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;
    [[nodiscard]] bool exists() const { return exists_; }
    void set(std::chrono::nanoseconds time) const;

   private:
    timer_t id_{};
    bool exists_{};
  };

  RealTimeShare(const Scheduling& ordinary, unsigned priority, std::chrono::milliseconds share);
  static void on_signal(int signal);
  void change();
  void begin_period();
  void end_share();

  const Scheduling ordinary_;
  const Scheduling in_real_time_;
  const std::chrono::milliseconds share_;
  const Timer work_;  // goes off when the share is used up
  const Timer rest_;  // goes off when the period ends
  // Changed by the signal's handler, which interrupts this thread only.
  std::chrono::steady_clock::time_point period_ends_;
  bool has_priority_{};
};

}  // namespace selvage::server::jobs
