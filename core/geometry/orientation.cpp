#include "core/geometry/orientation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace selvage::geometry {

Polygon transformed(const Polygon& polygon, Symmetry symmetry) {
  Polygon image(polygon.size());
  std::transform(polygon.begin(), polygon.end(), image.begin(), [&](Vec v) { return symmetry.apply(v); });
  if (symmetry.flips() && !image.empty()) std::reverse(image.begin() + 1, image.end());
  return image;
}

SplitOrientation split(const Orientation& orientation) {
  const double total = orientation.rotation.degrees + orientation.tilt.degrees;
  const double quarters = std::nearbyint(total / 90.0);
  const double rest = total - 90.0 * quarters;
  const int turns = static_cast<int>(std::fmod(quarters, 4.0));
  // rotate(rest) after flip == flip after rotate(-rest)
  return {Angle::of_degrees(orientation.flip ? -rest : rest), Symmetry{orientation.flip, turns}};
}

Polygon turned(const Polygon& polygon, Angle turn) {
  if (turn.degrees == 0.0) return polygon;
  const double radians = turn.degrees * (std::numbers::pi / 180.0);
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  Polygon image(polygon.size());
  std::transform(polygon.begin(), polygon.end(), image.begin(), [&](Vec v) {
    const auto x = static_cast<double>(v.x);
    const auto y = static_cast<double>(v.y);
    return Vec{std::llround(c * x - s * y), std::llround(s * x + c * y)};
  });
  // Rounding may leave repeated or collinear vertices; clean_polygon removes them.
  auto clean = clean_polygon(image);
  return clean ? std::move(clean->polygon) : image;
}

Polygon oriented(const Polygon& polygon, const Orientation& orientation) {
  const SplitOrientation parts = split(orientation);
  return transformed(turned(polygon, parts.turn), parts.symmetry);
}

}  // namespace selvage::geometry
