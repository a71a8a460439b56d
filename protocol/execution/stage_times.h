// Measures how long each stage of a motion takes.  The core reports stages but has no clock; the caller has one and
// calls this object when a stage begins.
#pragma once

#include "core/scene/observer.h"

namespace selvage::protocol::execution {

// Milliseconds.
struct StageTimes {
  double decomposition{}, sums{}, rows{}, solve{}, verify{}, total{};
};

class StageTimer {
 public:
  explicit StageTimer(double now_ms) : start_{now_ms}, entered_{now_ms} {}
  void enter(scene::Stage stage, double now_ms);
  [[nodiscard]] StageTimes times(double now_ms) const;

 private:
  [[nodiscard]] static double* slot(StageTimes& times, scene::Stage stage);

  double start_, entered_;
  scene::Stage stage_{scene::Stage::kOther};
  StageTimes times_;
};

}  // namespace selvage::protocol::execution
