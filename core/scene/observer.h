// How a motion tells what it is doing, for whoever holds a clock or a progress bar, and whose hands it works with: the
// core has neither clock nor threads.
#pragma once

#include <cstddef>
#include <functional>

#include "core/base/executor.h"
#include "core/geometry/lattice.h"
#include "core/lp/linear_program.h"

namespace selvage::scene {

enum class Stage { kSums, kRows, kSolve, kVerify, kOther };

struct Round {
  int number{};    // 1, 2, ...
  Coord length{};  // after it
};

// How large a linear program is.
struct ProgramSize {
  int columns{}, rows{};
  std::size_t nonzeros{};
};
[[nodiscard]] inline ProgramSize size_of(const lp::LinearProgram& program) {
  return {program.columns(), program.rows(), program.entries.size()};
}

struct Observer {
  std::function<void(Stage)> on_stage = [](Stage) {};  // a stage begins
  std::function<void(const Round&)> on_round = [](const Round&) {};
  std::function<void(const lp::LinearProgram&)> on_program = [](const lp::LinearProgram&) {};  // about to be solved
  const Executor* executor = &serial();  // never null; outlives the motion.  The answer does not depend on it
};

}  // namespace selvage::scene
