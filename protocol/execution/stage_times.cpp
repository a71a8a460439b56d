#include "protocol/execution/stage_times.h"

namespace selvage::protocol::execution {

double* StageTimer::slot(StageTimes& times, scene::Stage stage) {
  switch (stage) {
    case scene::Stage::kDecomposition: return &times.decomposition;
    case scene::Stage::kSums: return &times.sums;
    case scene::Stage::kRows: return &times.rows;
    case scene::Stage::kSolve: return &times.solve;
    case scene::Stage::kVerify: return &times.verify;
    case scene::Stage::kOther: break;
  }
  return nullptr;
}

void StageTimer::enter(scene::Stage stage, double now_ms) {
  if (double* spent = slot(times_, stage_)) *spent += now_ms - entered_;
  stage_ = stage;
  entered_ = now_ms;
}

StageTimes StageTimer::times(double now_ms) const {
  StageTimes times = times_;
  if (double* spent = slot(times, stage_)) *spent += now_ms - entered_;
  times.total = now_ms - start_;
  return times;
}

}  // namespace selvage::protocol::execution
