// A row of points across a strip: a linear program whose free room is given exactly in lattice units.
#pragma once

#include <vector>

#include "core/lp/linear_program.h"

namespace selvage::test {

// One lattice unit, in the unit of the columns, on the coarsest lattice that is chosen automatically: 2^28 units across
// the strip.
inline constexpr double kLatticeUnit = 1000.0 / (1 << 28);

// A row of points at least 1 apart, for which the strip leaves `spare` lattice units in total.
inline lp::LinearProgram row_of_points(int points, double spare) {
  using Row = std::vector<lp::LinearProgram::Entry>;
  lp::LinearProgram program;
  program.add_column(1, 0, lp::kInfinity);
  for (int j = 1; j < points; ++j) program.add_column(0, -lp::kInfinity, lp::kInfinity);
  for (int j = 1; j < points; ++j) program.add_row(Row{{j, 1}, {j - 1, -1}}, 1);
  program.add_row(Row{{points - 1, -1}}, 1 - points - spare * kLatticeUnit);
  return program;
}

}  // namespace selvage::test
