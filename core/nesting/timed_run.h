// A run that stops when a limit in time is used up.  The core has no clock: it asks its caller, between the stages of
// motions.
#pragma once

#include <functional>
#include <stop_token>
#include <utility>

#include "core/scene/run.h"

namespace selvage::nesting {

class TimedRun {
 public:
  // `elapsed`: the part of the limit that is used up; empty when there is none.
  TimedRun(const scene::Run& run, std::function<double()> elapsed)
      : elapsed_{std::move(elapsed)}, with_outer_{run.stop, [this] { stop_.request_stop(); }}, run_{run} {
    run_.stop = stop_.get_token();
    run_.observer.on_stage = [this, outer = run.observer.on_stage](scene::Stage stage) {
      if (elapsed_ && elapsed_() >= 1) stop_.request_stop();
      outer(stage);
    };
  }
  TimedRun(const TimedRun&) = delete;
  TimedRun& operator=(const TimedRun&) = delete;

  [[nodiscard]] const scene::Run& run() const { return run_; }

 private:
  std::function<double()> elapsed_;
  std::stop_source stop_;
  std::stop_callback<std::function<void()>> with_outer_;
  scene::Run run_;
};

}  // namespace selvage::nesting
