// Mends a solution that rows break which the program got after it was solved: the columns around each broken row are
// solved for again, and all others keep their values.
//
// In a program of a long marker, a row concerns two pieces, and making room for it concerns a few more: a program of
// these takes a thousandth of the time of the whole one.  The result is feasible, but it need not be optimal.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/executor.h"
#include "core/lp/linear_program.h"

namespace selvage::lp::solver {

// Deterministic, whatever the executor, whose threads share the rows that are far apart.
//
// x, changed near the rows that it breaks until it breaks none by more than allowed_violation (solve.h).  Nothing when
// that takes more columns than kMostMended around one row, or more than the program has around all of them, or when
// cancelled.
// REQUIRES: x has an entry per column, and keeps the columns' bounds.
[[nodiscard]] std::optional<std::vector<double>> mended(const LinearProgram& program, std::vector<double> x,
                                                        const std::stop_token& stop = {},
                                                        const Executor& executor = serial());

inline constexpr std::size_t kMostMended = 200;

}  // namespace selvage::lp::solver
