// A whole polygon as the overlap tests take it.
#pragma once

#include "core/geometry/overlap.h"
#include "core/geometry/polygon.h"

namespace selvage::test {

// `polygon` must outlive what is returned.
[[nodiscard]] inline geometry::PlacedPolygon placed(const Polygon& polygon, Vec at = {}) {
  return {polygon, box_of(polygon), at};
}
geometry::PlacedPolygon placed(Polygon&& polygon, Vec at = {}) = delete;

}  // namespace selvage::test
