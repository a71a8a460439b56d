// Queries of one star-shaped sum: whether a point is inside, and which parts of a segment are.
// Units: lattice units.
#pragma once

#include <utility>
#include <vector>

#include "core/minkowski/convolution/star_sum.h"

namespace selvage::minkowski::rings {

using Stretches = std::vector<std::pair<double, double>>;

// True when the point is inside by more than `margin`, measured from the edge that faces the point.  Takes logarithmic
// time and prepares nothing: for single questions.
[[nodiscard]] bool holds(const convolution::StarSum& sum, RealVec point, double margin);

// A star-shaped sum prepared for queries about many edges: its vertices relative to the centre, sorted by angle.
class Ring {
 public:
  // REQUIRES: `sum` outlives the ring.
  explicit Ring(const convolution::StarSum& sum);

  // Appends the intervals [t0, t1] of another ring's edge (t = 0 at its start, 1 at its end) that lie inside by more
  // than `margin`; they are not sorted.  Intervals that run along an edge of this ring, on the same exact line and in
  // the same direction, count as inside when `own_edges` is true and otherwise as outside.
  void append_inside(const convolution::SumEdge& edge, double margin, bool own_edges, Stretches& stretches) const;

 private:
  struct Corner {
    double angle{}, x{}, y{};  // start of an edge relative to the centre
    double dx{}, dy{};         // unit direction of the edge's exact line
    const convolution::SumEdge* edge{};
  };
  [[nodiscard]] std::size_t corner_before(double angle) const;
  [[nodiscard]] double depth(const Corner& corner, double x, double y) const {
    return corner.dx * (y - corner.y) - corner.dy * (x - corner.x);
  }
  // A segment in the ring's frame, with the arguments of append_inside.
  struct Question {
    double ax{}, ay{}, bx{}, by{};
    const convolution::SumEdge* edge{};
    double margin{};
    bool own_edges{};
    bool reversed{};  // a and b were swapped
  };
  [[nodiscard]] double margin_at(const Corner& corner, const Question& question) const;
  void append_turning(const Question& question, Stretches& stretches) const;
  void append_radial(const Question& question, Stretches& stretches) const;

  RealVec centre_;
  std::vector<Corner> corners_;
};

}  // namespace selvage::minkowski::rings
