// The outermost points on each side of a box: the corners of their hull, without the points between them.
// Units: lattice units.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "core/packing/cells/wedge_ring.h"

namespace selvage::packing::cells {

[[nodiscard]] inline std::array<RealVec, 4> corners_of(const RealBox& box) {
  return {{{box.low_x, box.low_y}, {box.high_x, box.low_y}, {box.high_x, box.high_y}, {box.low_x, box.high_y}}};
}

class BoxSides {
 public:
  explicit BoxSides(const RealBox& box) : box_{box} {}

  // False when the point lies on no side.
  bool include(RealVec p);
  void append_corners(std::vector<RealVec>& points) const;
  // Sets `chords` to the edges of the hull that do not lie along sides of the box, as half-planes: a point of the box
  // that lies in all of them lies in the hull.  False when the hull may be a single point.
  [[nodiscard]] bool set_chords(std::vector<HalfPlane>& chords) const;

 private:
  struct Extent {
    double least{std::numeric_limits<double>::infinity()}, most{-std::numeric_limits<double>::infinity()};
    void include(double value);
    [[nodiscard]] bool is_empty() const { return least > most; }
  };
  [[nodiscard]] bool is_along(RealVec from, RealVec to) const;

  RealBox box_;
  Extent left_, right_, bottom_, top_;
};

}  // namespace selvage::packing::cells
