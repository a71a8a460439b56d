// Orders for tests, made from a marker.
#pragma once

#include "core/marker/marker.h"

namespace selvage::test {

// The marker's pieces, all unplaced.
[[nodiscard]] Marker order_of(Marker marker);
// The same with every shape scaled.
[[nodiscard]] Marker order_of(Marker marker, double factor);
// The same with shapes scaled by 1 - part and 1 + part in turn.
[[nodiscard]] Marker graded_order_of(Marker marker, double part);

}  // namespace selvage::test
