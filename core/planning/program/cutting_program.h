// The integer program of cut planning over given candidates, after [Li94 5.3.4].
//
//   x[a][c]   units of plies of colour c under marker a
//   y[a]      lays of marker a
//   z[a]      1 when marker a is cut at all
//   w[a][r]   of the units of marker a in the colour of remnant r, those that lie on it
//   minimise  sum of unit[a] x[a][c] + lay[a] y[a] + marker z[a] - saving length[a] w[a][r]
//   so that   least[c][s] <= sum over a of a[s] x[a][c] <= most[c][s]     what is delivered
//             sum over c of x[a][c] <= (units of a lay) y[a]
//             x[a][c] <= most[a][c] z[a],   z[a] <= y[a]
//             sum over r of colour c of w[a][r] <= x[a][c],   sum over a of length[a] w[a][r] <= length of r
//             sum of z[a] >= the fewest markers that a cutting is known to have
//             sum of y[a] >= the lays that as many full bundles need as the order has garments
// This departs from the thesis, which maximises the sum of efficiencies: it minimises cost, and has colours, lays and
// fixed charges.  A marker without plies costs nothing, so the columns z are needed only when a marker costs.
#pragma once

#include <span>
#include <vector>

#include "core/lp/integer/integer_program.h"
#include "core/planning/program/cutting.h"

namespace selvage::planning::program {

class CuttingProgram {
 public:
  // `fewest`: only cuttings of that many markers or more are solutions.  REQUIRES: no ratio occurs twice.
  CuttingProgram(const orders::Problem& problem, std::vector<Candidate> candidates, int fewest = 1);

  [[nodiscard]] const lp::integer::IntegerProgram& program() const { return program_; }
  // The solution as a cutting.  REQUIRES: x is a solution of the program.
  [[nodiscard]] Cutting cutting_of(std::span<const double> x) const;
  // The cutting as a solution; empty when it uses a ratio that is no candidate.
  [[nodiscard]] std::vector<double> solution_of(const Cutting& cutting) const;

 private:
  struct Columns {
    std::vector<int> units;  // by colour; -1: none
    int lays{-1}, chosen{-1};
    std::vector<int> on_remnants;  // by remnant; -1: none
  };
  void add_candidate(const Candidate& candidate);
  void add_remnants(std::size_t candidate);
  void add_remnant_lengths();
  void add_deliveries();
  void add_counts(int fewest);

  const orders::Problem& problem_;
  std::vector<Candidate> candidates_;
  std::vector<Columns> columns_;  // by candidate
  lp::integer::IntegerProgram program_;
};

}  // namespace selvage::planning::program
