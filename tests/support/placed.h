// Makes a PlacedPolygon, the argument of the overlap tests, from a polygon.
#pragma once

#include "core/geometry/overlap.h"
#include "core/geometry/polygon.h"

namespace selvage::test {

// REQUIRES: `polygon` outlives the result.
[[nodiscard]] inline geometry::PlacedPolygon placed(const Polygon& polygon, Vec at = {}) {
  return {polygon, box_of(polygon), at};
}
geometry::PlacedPolygon placed(Polygon&& polygon, Vec at = {}) = delete;

}  // namespace selvage::test
