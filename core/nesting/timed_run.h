// A run that stops when a limit in time is used up.  The core has no clock: it asks its caller, between the stages of
// motions and while it computes the Minkowski sums of a stage.
#pragma once

#include <functional>
#include <stop_token>
#include <utility>

#include "core/base/executor.h"
#include "core/scene/run.h"

namespace selvage::nesting {

class TimedRun {
 public:
  // `elapsed`: the part of the limit that is used up; empty when there is none.
  TimedRun(const scene::Run& run, std::function<double()> elapsed)
      : elapsed_{std::move(elapsed)},
        with_outer_{run.stop, [this] { stop_.request_stop(); }},
        executor_{*run.executor, [this] { look(); }},
        run_{run} {
    run_.stop = stop_.get_token();
    run_.executor = &executor_;
    run_.observer.on_stage = [this, outer = run.observer.on_stage](scene::Stage stage) {
      look();
      outer(stage);
    };
  }
  TimedRun(const TimedRun&) = delete;
  TimedRun& operator=(const TimedRun&) = delete;

  [[nodiscard]] const scene::Run& run() const { return run_; }

 private:
  class LookingExecutor : public Executor {
   public:
    LookingExecutor(const Executor& outer, std::function<void()> look) : outer_{outer}, look_{std::move(look)} {}
    [[nodiscard]] std::size_t parallelism() const override { return outer_.parallelism(); }
    void for_each(std::size_t count, const Part& part) const override { outer_.for_each(count, part); }
    void on_step() const override {
      look_();
      outer_.on_step();
    }

   private:
    const Executor& outer_;
    std::function<void()> look_;
  };

  void look() {
    if (elapsed_ && elapsed_() >= 1) stop_.request_stop();
  }

  std::function<double()> elapsed_;
  std::stop_source stop_;
  std::stop_callback<std::function<void()>> with_outer_;
  LookingExecutor executor_;
  scene::Run run_;
};

}  // namespace selvage::nesting
