#include "protocol/stage_times.h"

namespace selvage {

double* StageTimer::slot(StageTimes& times, Stage stage) {
  switch (stage) {
    case Stage::kSums: return &times.sums;
    case Stage::kRows: return &times.rows;
    case Stage::kSolve: return &times.solve;
    case Stage::kVerify: return &times.verify;
    case Stage::kOther: break;
  }
  return nullptr;
}

void StageTimer::enter(Stage stage, double now_ms) {
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

}  // namespace selvage
