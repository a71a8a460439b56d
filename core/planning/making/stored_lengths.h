// Lengths estimated from stored markers of similar garments: a marker of the style has about the same utilisation as
// similar markers on the same cloth.
#pragma once

#include <span>
#include <vector>

#include "core/marker/marker.h"
#include "core/planning/making/garments.h"
#include "core/planning/orders/length_estimate.h"

namespace selvage::planning::making {

// One bundle of every size: what stored markers are compared with.
[[nodiscard]] Marker one_of_each_size(const Garments& garments);

// The areas and lengths of the stored markers whose pieces are similar to the style's, on cloth of about its width and
// with its spacing; areas are converted to the style's width.  Ignores all others, and markers that are incomplete or
// not valid.
// Units: millimetres.
[[nodiscard]] std::vector<orders::MadeLength> lengths_like(const Garments& garments, std::span<const Marker> stored);

}  // namespace selvage::planning::making
