// The linear relaxation of cut planning: a lower bound of the cost of every cutting, and what each candidate would add
// to it.
//
// Lays and markers are spread evenly over the plies: x units of a marker cost at least x / (units of a lay) lays, and
// x / (its most units) of the marker.  Only deliveries remain as rows, so that the program is small for any number of
// candidates.  When there are too many to list, more are generated: for each colour, the ratio of the least reduced
// cost is found by a search over the ratios, whose estimated price is linear in their bundles.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/lp/linear_program.h"
#include "core/planning/orders/length_estimate.h"
#include "core/planning/program/cutting.h"

namespace selvage::planning::program {

struct Relaxation {
  bool solved{};   // false: no cutting of the candidates delivers what is ordered, or the run was stopped
  double bound{};  // no cutting of any candidate, listed or not, costs less; up to the rounding of floating point
  std::vector<Candidate> candidates{};  // those given, and those generated
  // By candidate, at least 0: no cutting that uses it costs less than the bound and this.
  std::vector<double> extra{};
  double extra_of_others{lp::kInfinity};  // the same of every ratio that is not among the candidates
};

// Of the given candidates alone.  REQUIRES: no ratio occurs twice.
[[nodiscard]] Relaxation relax(const orders::Problem& problem, std::vector<Candidate> candidates,
                               std::stop_token stop = {});

// The lengths of ratios that are not given, and by how much they may exceed the table.
struct Estimated {
  orders::LengthEstimate lengths;
  double beyond{};
};
// Of all ratios.  `closed` are those that may not be generated.
[[nodiscard]] Relaxation relax_by_generation(const orders::Problem& problem, const std::vector<Candidate>& candidates,
                                             const Estimated& estimated, const std::vector<orders::Ratio>& closed,
                                             std::stop_token stop = {});

// A lower bound of the cost of the cuttings of these candidates that have this number of markers or more: the
// relaxation of CuttingProgram, in which lays and markers are columns of their own.  Infinite when there is none;
// nothing when it was stopped, or the solver gave up.  REQUIRES: no ratio occurs twice.
[[nodiscard]] std::optional<double> bound_with(const orders::Problem& problem, std::vector<Candidate> candidates,
                                               int fewest, std::stop_token stop = {});

}  // namespace selvage::planning::program
