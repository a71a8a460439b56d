// The execution context of a motion: the cache it takes Minkowski sums from, how it is cancelled, whom it reports to,
// and the threads it may use.  The answer of a motion depends on none of them, but for a cancelled one.
#pragma once

#include <stop_token>

#include "core/base/executor.h"
#include "core/minkowski/cache.h"
#include "core/scene/observer.h"

namespace selvage::scene {

struct Run {
  SumCache& sums;
  std::stop_token stop{};
  Observer observer{};
  const Executor* executor = &serial();  // never null; outlives the motion

  [[nodiscard]] bool stopped() const { return stop.stop_requested(); }
  // The run of a motion within a motion: stages and programs are reported as before, rounds are not.
  [[nodiscard]] Run quiet() const {
    Run inner = *this;
    inner.observer.on_round = [](const Round&) {};
    return inner;
  }
};

}  // namespace selvage::scene
