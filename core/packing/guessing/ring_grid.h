// Which rings may contain a position: the positions' range in equal parts, and for each part the rings whose boxes
// reach into it.  Most rings of fixed pieces are far from most positions of a body.
// Units: lattice units.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/packing/cells/wedge_ring.h"

namespace selvage::packing::guessing {

class RingGrid {
 public:
  RingGrid(const RealBox& range, std::span<const RealBox> boxes);

  // All boxes that contain the position, and some others: their numbers, ascending.
  // REQUIRES: the position lies in the range.
  [[nodiscard]] std::span<const std::uint32_t> near(RealVec position) const {
    const std::size_t part = part_of(position);
    return {rings_.data() + begins_[part], begins_[part + 1] - begins_[part]};
  }

 private:
  static constexpr std::size_t kParts = 16;  // along each axis
  // Monotone in both coordinates.
  [[nodiscard]] static std::size_t along(double value, double low, double parts);
  [[nodiscard]] std::size_t part_of(RealVec position) const {
    return along(position.y, range_.low_y, parts_y_) * kParts + along(position.x, range_.low_x, parts_x_);
  }

  RealBox range_;
  double parts_x_, parts_y_;           // per lattice unit
  std::vector<std::uint32_t> begins_;  // by part: its first ring; and the end
  std::vector<std::uint32_t> rings_;
};

}  // namespace selvage::packing::guessing
