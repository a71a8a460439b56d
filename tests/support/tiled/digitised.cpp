#include "tests/support/tiled/digitised.h"

#include <cmath>

#include "tests/support/random.h"

namespace selvage::test {
namespace {

Polygon digitised(Random& random, const Polygon& polygon, Coord pitch, Coord noise) {
  Polygon points;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec a = polygon[i];
    const Vec way = polygon[(i + 1) % polygon.size()] - a;
    const double length = std::hypot(static_cast<double>(way.x), static_cast<double>(way.y));
    const auto stretches = static_cast<int>(std::ceil(length / static_cast<double>(pitch)));
    points.push_back(a);
    for (int k = 1; k < stretches; ++k) {
      const double along = static_cast<double>(k) / stretches;
      const double inwards = random.part() * static_cast<double>(noise) / length;
      const double x = along * static_cast<double>(way.x) - inwards * static_cast<double>(way.y);
      const double y = along * static_cast<double>(way.y) + inwards * static_cast<double>(way.x);
      points.push_back(a + Vec{std::llround(x), std::llround(y)});
    }
  }
  return clean_polygon(points)->polygon;
}

}  // namespace

Marker digitised(const Marker& marker, Coord pitch, Coord noise) {
  Random random{1};
  Marker fine = marker;
  for (Shape& shape : fine.shapes) shape.outline = digitised(random, shape.outline, pitch, noise);
  return fine;
}

}  // namespace selvage::test
