// Questions to one star sum: is a point inside, which stretches of a segment are.
#pragma once

#include <utility>
#include <vector>

#include "core/minkowski/star_sum.h"

namespace selvage {

using Stretches = std::vector<std::pair<double, double>>;

// A star sum prepared for such questions: its vertices relative to the centre, sorted by angle.
class Ring {
 public:
  explicit Ring(const StarSum& sum);

  // Inside by more than `margin` lattice units, measured from the edge that faces the point.
  [[nodiscard]] bool holds(Real2 point, double margin) const;

  // The stretches [t0, t1] of the segment from a to b (t = 0 at a, 1 at b) that lie inside by more than `margin`;
  // appended, not sorted.  With `own_edges`, stretches that run along one of the ring's own edges, in its direction and
  // within `margin` of it, count as inside.
  void append_inside(Real2 a, Real2 b, double margin, bool own_edges, Stretches& stretches) const;

 private:
  struct Corner {
    double angle{}, x{}, y{};  // where an edge begins, relative to the centre
    double dx{}, dy{};         // the edge's unit direction
  };
  [[nodiscard]] std::size_t corner_before(double angle) const;
  [[nodiscard]] double depth(const Corner& corner, double x, double y) const {
    return corner.dx * (y - corner.y) - corner.dy * (x - corner.x);
  }
  // A segment in the ring's frame, with what append_inside was asked.
  struct Question {
    double ax{}, ay{}, bx{}, by{};
    double margin{};
    bool own_edges{};
    bool reversed{};  // a and b were exchanged
  };
  [[nodiscard]] double margin_at(const Corner& corner, const Question& question) const;
  void append_turning(const Question& question, Stretches& stretches) const;
  void append_radial(const Question& question, Stretches& stretches) const;

  Real2 centre_;
  std::vector<Corner> corners_;
};

}  // namespace selvage
