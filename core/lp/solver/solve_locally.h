// Solves a program again only around the rows that a solution breaks, because they were added after it was found: the
// columns near each broken row get new values, and all others keep theirs.
//
// In a program of a long marker, a row concerns two pieces, and making room for it concerns a few more: a program of
// these few is solved in a fraction of the time.  The result is feasible, but it need not be optimal.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/executor.h"
#include "core/lp/linear_program.h"

namespace selvage::lp::solver {

// x, changed near the rows that it breaks until it breaks none by more than allowed_violation (solve.h).  Nothing when
// that takes more columns than kMostLocalColumns around one row, or more than the program has around all of them, or
// when cancelled.  Deterministic, whatever the executor, whose threads share the rows that are far apart.
//
// REQUIRES: x has an entry per column, and keeps the columns' bounds.
[[nodiscard]] std::optional<std::vector<double>> solved_locally(const LinearProgram& program, std::vector<double> x,
                                                                const std::stop_token& stop = {},
                                                                const Executor& executor = serial());

inline constexpr std::size_t kMostLocalColumns = 200;

}  // namespace selvage::lp::solver
