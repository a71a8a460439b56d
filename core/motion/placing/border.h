// The border of the positions that are forbidden to a piece: the edges of a Minkowski sum, moved outwards by the
// spacing, and the arcs that then join them; moved inwards by the overlap allowance, they are joined by arcs where the
// sum's boundary turns inwards.  Coordinates are lattice units relative to a nearby origin, in doubles,
// accurate to a thousandth of a unit; positions found with them are proved elsewhere.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/lattice.h"
#include "core/geometry/real_plane.h"

namespace selvage::motion::placing {

// A part of the border.  The forbidden side is on the left, going from `a` to `b`; for an arc it is the disc, or what
// is outside of it.
struct BorderLine {
  RealVec a, b;              // the ends; for an arc, the centre twice
  double radius{};           // of an arc; otherwise 0
  std::uint32_t obstacle{};  // that this line is part of
  Vec anchor, direction;     // the exact line of an edge that was not moved, relative to the origin; else (0, 0)
  bool free_disc{};          // of an arc: the disc is free
  [[nodiscard]] bool arc() const { return radius > 0; }
};

// The point of the box that is nearest to `point`.
[[nodiscard]] RealVec nearest_in(const RealBox& box, RealVec point);
// Whether the point lies in the box, or no farther outside than the margin.
[[nodiscard]] bool holds(const RealBox& box, RealVec point, double margin);

[[nodiscard]] double squared_distance(RealVec p, RealVec q);
// Of two positions, lattice units.
[[nodiscard]] double distance_between(Vec p, Vec q);

// The line's point nearest to `point`.
[[nodiscard]] RealVec nearest_on(const BorderLine& line, RealVec point);
// True when the line enters the box.
[[nodiscard]] bool enters(const BorderLine& line, const RealBox& box);
// Appends the points that two lines have in common, at most two; none for parallel edges.
void append_crossings(const BorderLine& p, const BorderLine& q, std::vector<RealVec>& points);
// The unit vector at a point of the line that points away from the forbidden side.
[[nodiscard]] RealVec outwards(const BorderLine& line, RealVec at);

}  // namespace selvage::motion::placing
