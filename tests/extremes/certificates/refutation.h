// What refutes that a linear program has a best answer, in rationals: prices that no point can meet (the lemma of
// Farkas), or a ray along which the cost falls for ever.
//
// The simplex method's own rays are not asked for: most of Clp 1.17's prove nothing.  Two other programs, which always
// have a best answer, suggest the proof instead, so that any solver can: shortage_program() the prices and a feasible
// point, descent_program() the ray.  Nobody is believed.
#pragma once

#include <span>

#include "core/lp/linear_program.h"

namespace selvage::test {

// Minimise the cost of a step of at most 1 in every column that no row and no bound would end, were it taken for ever.
[[nodiscard]] lp::LinearProgram descent_program(const lp::LinearProgram& program);

// A proof when above 0: every point within the column bounds misses a row by at least so much.  Made exact beside
// `prices`, an entry per row.
[[nodiscard]] double infeasible_by(const lp::LinearProgram& program, std::span<const double> prices);
// A proof when above 0: by how much the cost falls, for every 1 of its longest column, along a ray that starts at a
// feasible point.  Made exact beside `ray` and the end of its first step from `point`, an entry per column each.
[[nodiscard]] double falls_for_ever_by(const lp::LinearProgram& program, std::span<const double> point,
                                       std::span<const double> ray);

}  // namespace selvage::test
