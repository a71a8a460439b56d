#include "core/lp/phase_one_program.h"

namespace selvage::lp {

LinearProgram phase_one_program(const LinearProgram& program) {
  LinearProgram relaxed;
  relaxed.cost.resize(program.cost.size());
  relaxed.lower = program.lower;
  relaxed.upper = program.upper;
  const int amount = relaxed.add_column(1, -1, kInfinity);
  std::vector<LinearProgram::Entry> row;
  for (int r = 0; r < program.rows(); ++r) {
    row.assign(program.row(r).begin(), program.row(r).end());
    row.push_back({amount, 1});
    relaxed.add_row(row, program.bound[static_cast<std::size_t>(r)]);
  }
  return relaxed;
}

}  // namespace selvage::lp
