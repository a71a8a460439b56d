// Small markers of squares, for which the expected results are obvious.
#pragma once

#include "core/marker/marker.h"

namespace selvage::test {

inline const Polygon kSquare{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
inline const Polygon kTriangle{{0, 0}, {20, 0}, {0, 20}};

// Squares of side 10 at the given positions, in a strip of width 100; the lattice unit is 0.1 mm.
[[nodiscard]] inline Marker squares(const std::vector<Vec>& places) {
  Marker marker;
  marker.resolution = {-1};
  marker.strip.width = 100;
  marker.shapes.push_back({.id = "square", .outline = kSquare, .tilt_limit = {}});
  for (std::size_t k = 0; k < places.size(); ++k) {
    marker.pieces.push_back({.id = std::to_string(k), .shape = {0}, .orientation = {}, .at = places[k]});
  }
  return marker;
}

}  // namespace selvage::test
