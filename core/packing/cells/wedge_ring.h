// The outside of one star-shaped Minkowski sum as a ring of wedge cells: each lies beyond one edge of the sum, between
// the rays from the centre through the edge's ends.  The cells cover the whole outside, so they are a convex covering
// in the sense of [Li94 8.2.1] that needs no union and no search.
//
// Outward rounding.  An edge's line passes through exact lattice points; coordinates stay below 2^42, so computing it
// in doubles and clipping by it is wrong by less than 2^-7 units, and the line is moved outwards by kLineSlack.  The
// centre may be any point of the kernel.  An end of an edge that is the crossing of two lines is rounded by up to a
// unit: its ray is turned outwards by kRaySlack units there, so that it stays outside of the exact ray at any distance.
// A cell thus contains all positions that it stands for, and what is concluded from cells holds for all valid layouts.
// What a search finds in them may overlap by a little in turn, and has to be placed and proved.
//
// Units: lattice units.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/real_plane.h"
#include "core/minkowski/cache.h"

namespace selvage::packing::cells {

inline constexpr double kLineSlack = 0x1p-6;  // lattice units
inline constexpr double kRaySlack = 1;        // lattice units
inline constexpr double kRounding = 0x1p-4;   // more than a clipped cell exceeds what it stands for along its edge

// The points with nx * x + ny * y >= c; the normal is a unit vector.
struct HalfPlane {
  double nx{}, ny{}, c{};
  [[nodiscard]] double room(RealVec p) const { return nx * p.x + ny * p.y - c; }
};

// Whether the point lies outside of the box, or on its border.
[[nodiscard]] inline bool is_beside(const RealBox& box, RealVec p) {
  return p.x <= box.low_x || p.x >= box.high_x || p.y <= box.low_y || p.y >= box.high_y;
}

// A convex polygon of at most seven corners: a box clipped by the three half-planes of a wedge.  Only the first `count`
// corners are set: cells are the innermost loop of a search.
struct Cell {
  std::array<double, 8> x, y;
  std::size_t count;
  [[nodiscard]] RealVec corner(std::size_t k) const { return {x[k], y[k]}; }
};

// Consecutive wedges of a ring.
struct Arc {
  std::uint32_t first{}, count{};
};

class WedgeRing {
 public:
  // The sum in the frame of its obstacle, moved by `offset`.  REQUIRES: at least three edges of positive length.
  WedgeRing(const minkowski::convolution::StarSum& sum, const minkowski::Obstacle& obstacle, Vec offset);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(wedges_.size()); }
  [[nodiscard]] Arc whole() const { return {0, size()}; }
  [[nodiscard]] const RealBox& box() const { return box_; }
  [[nodiscard]] RealVec centre() const { return centre_; }
  // Sets `cell` to the part of the box in a wedge.  False when there is none.
  [[nodiscard]] bool clip(std::uint32_t wedge, const RealBox& box, Cell& cell) const;
  // Whether the part of `box` in a wedge certainly lies in `part`, which is a part of the box: cheaper than clipping.
  [[nodiscard]] bool lies_within(std::uint32_t wedge, const RealBox& box, const RealBox& part) const;
  // Whether a wedge certainly lies in all the half-planes.  False, too, if the centre lies inside one of them.
  [[nodiscard]] bool lies_within(std::uint32_t wedge, std::span<const HalfPlane> planes) const;
  // The part of an arc that rays to the box pass: in its other wedges the box has no position.  Counted from the arc's
  // first wedge, and where the part of a whole ring goes on beyond the last one, `end` is more than its size.
  struct Part {
    std::uint32_t begin{}, end{};
  };
  [[nodiscard]] Part part_facing(Arc arc, const RealBox& box) const;
  // The wedge that the point's ray passes.
  [[nodiscard]] std::uint32_t facing(RealVec p) const;
  // How far the point lies inside the wedge's line, beyond the slack; negative outside.
  [[nodiscard]] double depth(std::uint32_t wedge, RealVec p) const { return -wedges_[wedge].beyond.room(p); }
  // Whether the point is certainly outside of the ring.
  [[nodiscard]] bool is_free(RealVec p) const { return is_beside(p) || depth(facing(p), p) <= 0; }
  // Whether the point lies outside of the ring's box.
  [[nodiscard]] bool is_beside(RealVec p) const { return cells::is_beside(box_, p); }
  // The corner of the sum at which the edge of the wedge starts; a unit off, at most, where two lines cross.
  [[nodiscard]] RealVec corner(std::uint32_t wedge) const { return corners_[wedge]; }
  // The wedge as half-planes: beyond its edge's line, after the ray through the edge's start, before that through its
  // end.
  [[nodiscard]] std::array<HalfPlane, 3> sides(std::uint32_t wedge) const {
    return {wedges_[wedge].beyond, wedges_[wedge].after, wedges_[wedge].before};
  }
  // The exact line of the wedge's edge.
  [[nodiscard]] HalfPlane line(std::uint32_t wedge) const {
    const HalfPlane& beyond = wedges_[wedge].beyond;
    return {beyond.nx, beyond.ny, beyond.c + kLineSlack};
  }
  // Whether the sum turns inwards at the corner where the wedge's edge starts.  Beyond the edges on both sides of such
  // a corner, everything near it is free; beyond only one of them it is not.
  [[nodiscard]] bool is_notch(std::uint32_t wedge) const {
    const HalfPlane& before = wedges_[previous(wedge)].beyond;
    const HalfPlane& own = wedges_[wedge].beyond;
    return before.nx * own.ny - before.ny * own.nx < 0;
  }
  [[nodiscard]] std::uint32_t next(std::uint32_t wedge) const { return wedge + 1 < size() ? wedge + 1 : 0; }
  [[nodiscard]] std::uint32_t previous(std::uint32_t wedge) const { return (wedge > 0 ? wedge : size()) - 1; }
  // The corner nearest in angle to the ray at `quarters` quarter turns from the point's ray, named by the wedge that
  // starts there.
  [[nodiscard]] std::uint32_t corner_near(RealVec p, int quarters) const;

 private:
  struct Wedge {
    HalfPlane beyond, after, before;  // the edge's line, the ray through its start, the ray through its end
  };
  // The last corner whose angle is not more, or else the last of all.
  [[nodiscard]] std::uint32_t corner_before(double angle) const;
  [[nodiscard]] std::size_t sector_count() const { return 4 * angles_.size(); }
  [[nodiscard]] std::size_t sector_of(double angle) const;
  void set_sectors();
  [[nodiscard]] Arc facing_box(const RealBox& box) const;

  RealVec centre_;
  std::vector<Wedge> wedges_;     // counter-clockwise
  std::vector<RealVec> corners_;  // at each wedge's start
  std::vector<double> angles_;    // of these corners; ascending
  // The full turn in four equal sectors for each corner: the first corner that lies in each or behind it.
  std::vector<std::uint32_t> sectors_;
  double angle_slack_{};  // by which one of these angles may be wrong
  RealBox box_;
};

}  // namespace selvage::packing::cells
