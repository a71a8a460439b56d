// The border of what one piece may not enter: the edges of a Minkowski sum, moved outwards by the spacing, and the arcs
// that then join them.  Coordinates are lattice units relative to an origin near by, in doubles: good to a thousandth
// of a unit; what is found with them is advice, and proved elsewhere.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/lattice.h"
#include "core/minkowski/ring.h"

namespace selvage::motion::placing {

// A stretch of the border.  Forbidden is its left, seen from `a` to `b`; of an arc, the disc.
struct BorderLine {
  RealVec a, b;              // the ends; of an arc, the centre twice
  double radius{};           // of an arc, else 0
  std::uint32_t obstacle{};  // whose it is
  Vec anchor, direction;     // the exact line of an edge that was not moved, relative to the origin; else (0, 0)
  [[nodiscard]] bool arc() const { return radius > 0; }
};

// A box in the same coordinates.
struct RealBox {
  RealVec low, high;
  [[nodiscard]] RealVec nearest_to(RealVec point) const;
  [[nodiscard]] bool holds(RealVec point, double margin) const;
};

[[nodiscard]] double squared_distance(RealVec p, RealVec q);

// The line's point nearest to `point`.
[[nodiscard]] RealVec nearest_on(const BorderLine& line, RealVec point);
// True when the line comes into the box.
[[nodiscard]] bool enters(const BorderLine& line, const RealBox& box);
// Appends the points, two at most, that two lines have in common; none for two edges that are parallel.
void append_crossings(const BorderLine& p, const BorderLine& q, std::vector<RealVec>& points);
// The unit vector at a point of the line that leads away from what is forbidden.
[[nodiscard]] RealVec outwards(const BorderLine& line, RealVec at);

}  // namespace selvage::motion::placing
