// The linear program of one round of floating: the position model with the widths of gaps as columns [Li94 7.3].
//
// Rows are n . (d_q - d_p) - width >= margin - slack with unit n: half-planes moved outwards by as much as the width
// says [Li94 7.2].  A gap's half-planes are chosen at its present clearance, so that staying put is feasible.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/lp/linear_program.h"
#include "core/model/position_model.h"
#include "core/motion/floating/gap.h"

namespace selvage::motion::floating {

enum class FloatMode {
  kLargestMinimum,  // the least distance as large as it can be [Li94 7.4]
  kGivenDistance,  // every distance at least the given one where there is room for it, with the least motion [Li94 7.5]
  kLargestTotal,   // the sum of all distances as large as it can be [Li94 7.6]
  kUniform,        // the sum of all distances, minus the deviation of each from their mean [Li94 7.7]
  kTwoStep,        // the largest minimum; then again for the gaps that do not limit it [Li94 7.8]
};

// A gap as a round sees it.
struct FloatGap {
  Gap gap;
  double now{};   // its width, lattice units, at most FloatAim::most
  Coord least{};  // the width that it must keep; proved
  bool held{};    // does not have to become wider, only to stay at `keep`
  double keep{};
};

struct FloatAim {
  FloatMode mode{};
  double most{};           // lattice units: wider gaps count as this wide
  Strip strip;             // ends where the marker may end
  std::vector<Vec> start;  // positions that motion is measured from
};

// What a round maximises, in lattice units, given the gaps' widths: the program's objective, after rounding.
[[nodiscard]] double worth_of(const FloatAim& aim, std::span<const FloatGap> gaps, std::span<const double> widths,
                              const marker::PlacedPieces& pieces);

// normal . (displacement of `second` - displacement of `first`) - width of the gap >= margin - slack; an edge never
// moves.
struct WidthRow {
  std::size_t gap{};
  double nx{}, ny{};
  double slack{};   // the distance to the half-plane's line now
  double margin{};  // covers the rounding of displacements to the lattice
};
// The rows of all gaps that can matter while no piece moves farther than `trust` (lattice units) on either axis; only
// some of them when cancelled.
[[nodiscard]] std::vector<WidthRow> width_rows(const scene::Scene& scene, const FloatAim& aim,
                                               std::span<const FloatGap> gaps, double trust,
                                               const std::stop_token& stop);

class FloatProgram {
 public:
  // The referenced values must outlive this.
  FloatProgram(const scene::Scene& scene, const model::Ties& ties, const FloatAim& aim, std::span<const FloatGap> gaps,
               std::span<const WidthRow> rows, double trust);

  [[nodiscard]] const lp::LinearProgram& program() const { return model_.program(); }
  [[nodiscard]] std::vector<RealVec> displacements(const lp::LpSolution& s) const { return model_.displacements(s.x); }
  // The worth that a solution promises, before rounding; lattice units.
  [[nodiscard]] double promised(const lp::LpSolution& solution) const;
  // The gaps whose room in a solution is uncertain: rounding may make them narrower than their `least`.
  [[nodiscard]] std::vector<std::size_t> uncertain(const lp::LpSolution& solution) const;
  // For each gap, the gain in worth from one unit of room in it.
  [[nodiscard]] std::vector<double> loads(const lp::LpSolution& solution) const;

 private:
  void bound_motion(double trust);
  void add_widths();
  void add_shared_width(std::span<const double> room);
  void add_own_widths(std::span<const double> room);
  void add_rows();
  void add_uniformity();
  [[nodiscard]] int add_mean(std::span<const int> columns);
  void add_motion();
  [[nodiscard]] bool tied(const Gap& gap) const;

  const scene::Scene& scene_;
  const model::Ties& ties_;
  const FloatAim& aim_;
  std::span<const FloatGap> gaps_;
  std::span<const WidthRow> rows_;
  model::PositionModel model_;
  std::vector<int> width_;               // each gap's column
  std::vector<std::size_t> gap_of_row_;  // by row of the program; gaps_.size() for rows of no gap
};

}  // namespace selvage::motion::floating
