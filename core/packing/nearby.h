// The part of a marker that a containment has to look at: the pieces that move, and those near enough to the container
// to be in their way.  In a long marker most pieces are neither.
//
// Pieces with cloth's rules stay in it wherever they lie, because rules may refer to pieces far away (pieces of a
// shade).
#pragma once

#include <cstdint>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::packing {

struct Nearby {
  Marker marker;
  std::vector<bool> moving;          // by piece of this marker
  std::vector<std::uint32_t> place;  // of each of its pieces in the whole marker
};

// REQUIRES: pieces that move stay inside the box.
[[nodiscard]] Nearby nearby(const Marker& whole, const std::vector<bool>& moving, const Box& box);

// The whole marker with these pieces as they lie now.
[[nodiscard]] Marker as_part_of(Marker whole, const Nearby& nearby, const Marker& now);

}  // namespace selvage::packing
