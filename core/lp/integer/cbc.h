// Branch and cut, by COIN-OR Cbc.  No type of Cbc appears in this header.
#pragma once

#include <span>
#include <stop_token>

#include "core/lp/integer/integer_program.h"

namespace selvage::lp::integer {

struct IntegerLimits {
  int nodes{10'000};       // of the search tree; work is limited by count, so that the answer does not depend on time
  double gap{};            // relative: the search ends when objective - bound is at most gap * |objective|
  int depth_of_dives{50};  // rounds of the heuristics that dive for a first solution; 0: none
};

// Deterministic, unless it is stopped.  `start`, when not empty, is a solution that the search improves on: the answer
// is never worse.  Every solution returned satisfies is_solution.  Stops at the next node once `stop` is requested.
// REQUIRES: lower <= upper, no NaN, at least one column; `start` is empty or a solution.
[[nodiscard]] IntegerSolution solve_by_branch_and_cut(const IntegerProgram& program, const IntegerLimits& limits,
                                                      std::span<const double> start = {}, std::stop_token stop = {});

}  // namespace selvage::lp::integer
