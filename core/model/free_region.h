// Free regions: convex parts of the outside of a Minkowski sum that contain the present relative position of two pieces
// [Li94 4.1.2].  While the relative position stays inside, the pieces cannot overlap; that is a linear constraint.
#pragma once

#include <vector>

#include "core/geometry/real_plane.h"
#include "core/minkowski/cache.h"

namespace selvage::model {

// How a region is chosen.
enum class RegionRule {
  kGreedy,  // cuts along the line of the nearest edge that faces the position, drops the edges that this excludes, and
            // continues with the nearest of the rest
  kWalk,    // the walk of the thesis: from the edge that faces the position both ways along the boundary, extending
            // edges
};

// The relative positions r with cross(direction, r - anchor) <= 0: on the line or to its right, outside of the sum. The
// line passes exactly through lattice points.
struct HalfPlane {
  Vec anchor, direction;
};
// The distance of r from the line: positive inside, negative outside; lattice units.  Computed exactly, rounded once.
[[nodiscard]] double slack_of(const HalfPlane& side, Vec r);

struct RegionSettings {
  RegionRule rule{};
  double reach{};     // lattice units; edges that are farther than this from the position are ignored
  Coord spacing{};    // the caller moves the half-planes outwards by this, and the position still fits
  RealVec towards{};  // of edges equally near (at a corner), prefer the one that is least in the way of this direction;
                      // (0, 0): the one whose line is farthest
  RealVec closing{};  // without `towards`: the same preference at a corner that the position touches, where all lines
                      // are equally far; (0, 0): none
};

// A free region about the relative position `r` = q - p, as the half-planes that bound it within reach.
// With a spacing, an edge whose line passes r at a smaller distance than that is cut off by another line: through the
// edge's point nearest to r, perpendicular to the direction from there to r [Li94 7.2 moves lines only].  The position
// keeps its distance from that line whenever the pieces keep theirs.  The walk has no such lines, so that the greedy
// rule is used instead.  Edges that r is behind by no more than rounding count as facing it: the half-planes then make
// r come out.
[[nodiscard]] std::vector<HalfPlane> free_region(const minkowski::Obstacle& obstacle, Vec r,
                                                 const RegionSettings& settings);

// A pair that may overlap: it lies at `r`, and is allowed to be as far inside the sum as `allowance`.
struct OverlappingPosition {
  Vec r;
  Vec about;  // the relative position outside the sum that the region is chosen about; r: the nearest one
  Coord allowance{};
};
// A free region whose half-planes the caller moves inwards by the allowance: it then contains r, and each of its points
// is within the allowance of the outside of the sum.  Where two half-planes meet, the points within the allowance end
// in an arc; chords of the arc are added, which touch it at the ends and at the point nearest to r.  Lines and chords
// are accurate to a unit; the rule is always the greedy one.  (core/model/overlap_region.cpp)
[[nodiscard]] std::vector<HalfPlane> overlap_region(const minkowski::Obstacle& obstacle,
                                                    const OverlappingPosition& position,
                                                    const RegionSettings& settings);

}  // namespace selvage::model
