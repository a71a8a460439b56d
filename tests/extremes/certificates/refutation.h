// Exact proofs, in rational arithmetic, that a linear program has no optimum: prices that no point can satisfy (Farkas'
// lemma), or a ray along which the cost decreases without bound.
//
// The simplex method's own rays are not used, because most of those of Clp 1.17 prove nothing.  Instead, two other
// programs that always have an optimum suggest the proof, so any solver can be used: phase_one_program() gives prices
// and a feasible point, and descent_program() gives a ray.  The suggestions are made exact and then checked.
#pragma once

#include <span>

#include "core/lp/linear_program.h"

namespace selvage::test {

// The program that minimises the cost of a direction (at most 1 in every column) in which no row and no bound ever ends
// the motion.
[[nodiscard]] lp::LinearProgram descent_program(const lp::LinearProgram& program);

// A positive result is a proof of infeasibility: every point within the column bounds violates a row by at least this
// much.  The proof is exact and near `prices`, which has an entry per row.
[[nodiscard]] double infeasible_by(const lp::LinearProgram& program, std::span<const double> prices);
// A positive result is a proof of unboundedness: the decrease of the cost, per unit of the column that changes most,
// along a ray that starts at a feasible point.  The proof is exact and near `ray` and the end of its first step from
// `point`; both have an entry per column.
[[nodiscard]] double falls_for_ever_by(const lp::LinearProgram& program, std::span<const double> point,
                                       std::span<const double> ray);

}  // namespace selvage::test
