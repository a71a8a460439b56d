// The areas of pieces, in square lattice units.
#pragma once

#include "core/marker/marker.h"

namespace selvage::remake::substitution {

[[nodiscard]] inline double area_of(const Marker& marker, const Piece& piece) {
  return geometry::area_of(marker.shapes[piece.shape.value].outline);
}
[[nodiscard]] inline double placed_area(const Marker& marker) {
  double area = 0;
  for (const Piece& piece : marker.pieces) area += area_of(marker, piece);
  return area;
}
[[nodiscard]] inline double whole_area(const Marker& marker) {
  double area = placed_area(marker);
  for (const Piece& piece : marker.unplaced) area += area_of(marker, piece);
  return area;
}

}  // namespace selvage::remake::substitution
