// How a motion tells what it is doing, for whoever holds a clock or a progress bar: the core has neither.
#pragma once

#include <functional>

#include "core/geometry/lattice.h"

namespace selvage {

enum class Stage { kSums, kRows, kSolve, kVerify, kOther };

struct Round {
  int number{};    // 1, 2, ...
  Coord length{};  // after it
};

struct Observer {
  std::function<void(Stage)> on_stage = [](Stage) {};  // a stage begins
  std::function<void(const Round&)> on_round = [](const Round&) {};
};

}  // namespace selvage
