// Random polygons at random positions on a strip: some overlap, some leave the strip.
#pragma once

#include "tests/core/marker/squares.h"
#include "tests/support/polygons.h"

namespace selvage::test {

[[nodiscard]] inline Marker random_layout(Random& random, std::size_t pieces, Coord extent) {
  Marker marker = squares({});
  marker.strip.width = 1000;
  marker.shapes.clear();
  for (int k = 0; k < 5; ++k) {
    marker.shapes.push_back(
        {.id = std::to_string(k), .outline = random_polygon(random, 60), .rotations = {}, .tilt_limit = {}});
  }
  for (std::size_t k = 0; k < pieces; ++k) {
    const Angle rotation = Angle::of_degrees(90.0 * static_cast<double>(random.between(0, 3)));
    marker.pieces.push_back({.id = std::to_string(k),
                             .shape = {static_cast<std::uint32_t>(random.below(5))},
                             .orientation = {false, rotation, {}},
                             .at = random.point(0, extent)});
  }
  return marker;
}

}  // namespace selvage::test
