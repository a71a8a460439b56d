// Questions to one star sum: is a point inside, which stretches of a segment are.
#pragma once

#include <utility>
#include <vector>

#include "core/minkowski/convolution/star_sum.h"

namespace selvage::minkowski {

using Stretches = std::vector<std::pair<double, double>>;

// A star sum prepared for such questions: its vertices relative to the centre, sorted by angle.
class Ring {
 public:
  // `sum` must outlive it.
  explicit Ring(const convolution::StarSum& sum);

  // Inside by more than `margin` lattice units, measured from the edge that faces the point.
  [[nodiscard]] bool holds(RealVec point, double margin) const;

  // The stretches [t0, t1] of another ring's edge (t = 0 where it begins, 1 where it ends) that lie inside by more than
  // `margin`; appended, not sorted.  Stretches that run along one of the ring's own edges, on the same exact line and
  // in its direction, count as inside with `own_edges`, and else as outside.
  void append_inside(const convolution::SumEdge& edge, double margin, bool own_edges, Stretches& stretches) const;

 private:
  struct Corner {
    double angle{}, x{}, y{};  // where an edge begins, relative to the centre
    double dx{}, dy{};         // the edge's unit direction, that of its exact line
    const convolution::SumEdge* edge{};
  };
  [[nodiscard]] std::size_t corner_before(double angle) const;
  [[nodiscard]] double depth(const Corner& corner, double x, double y) const {
    return corner.dx * (y - corner.y) - corner.dy * (x - corner.x);
  }
  // A segment in the ring's frame, with what append_inside was asked.
  struct Question {
    double ax{}, ay{}, bx{}, by{};
    const convolution::SumEdge* edge{};
    double margin{};
    bool own_edges{};
    bool reversed{};  // a and b were exchanged
  };
  [[nodiscard]] double margin_at(const Corner& corner, const Question& question) const;
  void append_turning(const Question& question, Stretches& stretches) const;
  void append_radial(const Question& question, Stretches& stretches) const;

  RealVec centre_;
  std::vector<Corner> corners_;
};

}  // namespace selvage::minkowski
