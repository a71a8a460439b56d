// A linear program's rows as the matrix that the solvers of COIN-OR read.  For their adapters only.
#pragma once

#include <CoinPackedMatrix.hpp>
#include <vector>

#include "core/lp/linear_program.h"

namespace selvage::lp::solver {

[[nodiscard]] inline CoinPackedMatrix coin_rows(const LinearProgram& program) {
  std::vector<int> column(program.entries.size());
  std::vector<double> value(program.entries.size());
  for (std::size_t k = 0; k < program.entries.size(); ++k) {
    column[k] = program.entries[k].column;
    value[k] = program.entries[k].value;
  }
  const std::vector<CoinBigIndex> start(program.row_start.begin(), program.row_start.end());
  return {false,        program.columns(), program.rows(), static_cast<CoinBigIndex>(column.size()),
          value.data(), column.data(),     start.data(),   nullptr};
}

}  // namespace selvage::lp::solver
