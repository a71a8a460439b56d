// Where a body can lie beside all that is fixed, on a grid over its range.  A box of positions may be excluded by
// several rings together although none of them excludes it alone; examining ring after ring does not show this, and the
// grid does.
//
// A cell is excluded if one of the rings holds it, with more units around it than the ring's corners are rounded by
// (wedge_ring.h).  So every lattice position in it is certainly forbidden.
// Units: lattice units.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/packing/cells/wedge_ring.h"

namespace selvage::packing::cells {

class FreeCells {
 public:
  explicit FreeCells(const RealBox& range);
  // Excludes the cells inside the ring.
  void exclude(const WedgeRing& ring);
  // A box that holds all lattice positions in `box` whose cells are free: no larger than `box`, and nothing when all
  // are excluded.  REQUIRES: `box` has whole ends and lies in the range.
  [[nodiscard]] std::optional<RealBox> within(const RealBox& box) const;

 private:
  static constexpr std::size_t kCount = 64;  // along each axis
  [[nodiscard]] static std::size_t at(double value, double low, double size);
  [[nodiscard]] std::size_t column_of(double x) const { return at(x, range_.low_x, width_); }
  [[nodiscard]] std::size_t row_of(double y) const { return at(y, range_.low_y, height_); }

  RealBox range_;
  double width_, height_;                   // of a cell
  std::array<std::uint64_t, kCount> rows_;  // a bit for each free cell
};

}  // namespace selvage::packing::cells
