// What stored markers of similar garments say about lengths: the marker of a style is about as well filled as others of
// its kind on the same cloth.
#pragma once

#include <span>
#include <vector>

#include "core/marker/marker.h"
#include "core/planning/making/garments.h"
#include "core/planning/orders/length_estimate.h"

namespace selvage::planning::making {

// One bundle of every size: what stored markers are compared with.
[[nodiscard]] Marker one_of_each_size(const Garments& garments);

// The areas and lengths of the stored markers whose pieces are much like the style's, on cloth of about its width and
// with its spacing; areas are those that they would have on the style's width.  Passes over all others, and those that
// are not whole or not valid.
// Units: millimetres.
[[nodiscard]] std::vector<orders::MadeLength> lengths_like(const Garments& garments, std::span<const Marker> stored);

}  // namespace selvage::planning::making
