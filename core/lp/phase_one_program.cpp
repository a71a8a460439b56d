#include "core/lp/phase_one_program.h"

namespace selvage::lp {

LinearProgram phase_one_program(const LinearProgram& program) {
  LinearProgram shortage;
  shortage.cost.resize(program.cost.size());
  shortage.lower = program.lower;
  shortage.upper = program.upper;
  const int amount = shortage.add_column(1, -1, kInfinity);
  std::vector<LinearProgram::Entry> row;
  for (int r = 0; r < program.rows(); ++r) {
    row.assign(program.row(r).begin(), program.row(r).end());
    row.push_back({amount, 1});
    shortage.add_row(row, program.bound[static_cast<std::size_t>(r)]);
  }
  return shortage;
}

}  // namespace selvage::lp
