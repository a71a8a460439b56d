// Orders for tests, made from a marker.
#pragma once

#include <span>
#include <vector>

#include "core/matching/label.h"

namespace selvage::test {

// Pieces that are not called anything.
[[nodiscard]] matching::LabelledMarker unlabelled(Marker marker);
[[nodiscard]] std::vector<matching::LabelledMarker> unlabelled(std::span<const Marker> markers);

// The marker's pieces, all unplaced.
[[nodiscard]] Marker order_of(Marker marker);
// The same with every shape scaled.
[[nodiscard]] Marker order_of(Marker marker, double factor);
// The same with shapes scaled by 1 - part and 1 + part in turn.
[[nodiscard]] Marker graded_order_of(Marker marker, double part);

}  // namespace selvage::test
