// The boxes of all pieces where they lie, so that those near a place are found without a look at the pieces.
// Units: model units.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/nesting/layout/layout.h"

namespace selvage::nesting::layout {

class PlacedBoxes {
 public:
  // REQUIRES: the set outlives the boxes.
  explicit PlacedBoxes(const PieceSet& set) : set_{&set} {}

  // Takes the boxes of the layout's pieces.
  void take(const Layout& layout);
  // Replaces `pieces` by those whose boxes lie less than `apart` from the box on both axes, and by some that lie a
  // rounding error farther away; in rising order.
  void find_near(const RealBox& box, double apart, std::vector<std::uint32_t>& pieces) const;

 private:
  const PieceSet* set_;
  std::vector<RealBox> boxes_;  // by piece
};

}  // namespace selvage::nesting::layout
