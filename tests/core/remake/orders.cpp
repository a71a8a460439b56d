#include "tests/core/remake/orders.h"

#include <cmath>
#include <utility>

namespace selvage::test {
namespace {

void scale(Shape& shape, double factor) {
  for (Vec& v : shape.outline) {
    v = {std::llround(static_cast<double>(v.x) * factor), std::llround(static_cast<double>(v.y) * factor)};
  }
  if (const auto clean = geometry::clean_polygon(shape.outline)) shape.outline = clean->polygon;
}

}  // namespace

matching::LabelledMarker unlabelled(Marker marker) {
  return {std::move(marker), {}};
}

std::vector<matching::LabelledMarker> unlabelled(std::span<const Marker> markers) {
  std::vector<matching::LabelledMarker> all;
  for (const Marker& marker : markers) all.push_back(unlabelled(marker));
  return all;
}

Marker order_of(Marker marker) {
  for (Piece& piece : marker.pieces) {
    piece.at = {};
    marker.unplaced.push_back(piece);
  }
  marker.pieces.clear();
  return marker;
}

Marker order_of(Marker marker, double factor) {
  for (Shape& shape : marker.shapes) scale(shape, factor);
  return order_of(std::move(marker));
}

Marker graded_order_of(Marker marker, double part) {
  double sign = 1;
  for (Shape& shape : marker.shapes) scale(shape, 1 + (sign = -sign) * part);
  return order_of(std::move(marker));
}

}  // namespace selvage::test
