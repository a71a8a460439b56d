// Free regions: convex parts of the outside of a Minkowski sum that hold the present relative position of two pieces
// [Li94 4.1.2].  Inside such a region the pieces cannot overlap, and that is linear.
#pragma once

#include <vector>

#include "core/geometry/real_vec.h"
#include "core/minkowski/cache.h"

namespace selvage::model {

// How a region is chosen.
enum class RegionRule {
  kGreedy,  // cut along the line of the nearest facing edge, skip the edges this excludes, go on with the next nearest
  kWalk,    // the thesis' walk: from the edge that faces the position, both ways along the boundary, extending edges
};

// The relative positions r with cross(direction, r - anchor) <= 0: on the line or to its right, where the sum is not.
// The line is an exact lattice line.
struct HalfPlane {
  Vec anchor, direction;
};
// How far r lies inside; negative outside.  Computed exactly, rounded once; lattice units.
[[nodiscard]] double slack_of(const HalfPlane& side, Vec r);

struct RegionSettings {
  RegionRule rule{};
  double reach{};     // lattice units; edges farther than this from the position are not looked at
  Coord spacing{};    // the half-planes will be moved outwards by this: choose them so that the position still fits
  RealVec towards{};  // of edges equally near (at a corner), prefer the one that is least in the way of this direction;
                      // (0, 0): the one whose line is farthest
};

// A free region about the relative position `r` = q - p, as the half-planes that bound it within reach.
// With a spacing, an edge whose line passes r nearer than that is cut off by the line through its nearest point square
// to the way there [Li94 7.2 moves lines only], which r keeps its distance from whenever the pieces do; the walk knows
// no such lines and gives way to the greedy rule. Edges that r is behind by no more than rounding count as facing it:
// the half-planes then ask for r to come out.
[[nodiscard]] std::vector<HalfPlane> free_region(const minkowski::Obstacle& obstacle, Vec r,
                                                 const RegionSettings& settings);

}  // namespace selvage::model
