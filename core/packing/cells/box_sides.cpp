#include "core/packing/cells/box_sides.h"

#include <algorithm>
#include <cmath>

namespace selvage::packing::cells {

void BoxSides::Extent::include(double value) {
  least = std::min(least, value);
  most = std::max(most, value);
}

bool BoxSides::include(RealVec p) {
  if (p.x == box_.low_x) {
    left_.include(p.y);
  } else if (p.x == box_.high_x) {
    right_.include(p.y);
  } else if (p.y == box_.low_y) {
    bottom_.include(p.x);
  } else if (p.y == box_.high_y) {
    top_.include(p.x);
  } else {
    return false;
  }
  return true;
}

void BoxSides::append_corners(std::vector<RealVec>& points) const {
  const auto append = [&points](const Extent& extent, const auto& point) {
    if (extent.is_empty()) return;
    points.push_back(point(extent.least));
    if (extent.most > extent.least) points.push_back(point(extent.most));
  };
  append(bottom_, [this](double x) { return RealVec{x, box_.low_y}; });
  append(right_, [this](double y) { return RealVec{box_.high_x, y}; });
  append(top_, [this](double x) { return RealVec{x, box_.high_y}; });
  append(left_, [this](double y) { return RealVec{box_.low_x, y}; });
}

// Along a side of the box, with the box to the left.
bool BoxSides::is_along(RealVec from, RealVec to) const {
  return (from.y == box_.low_y && to.y == box_.low_y && from.x < to.x) ||
         (from.x == box_.high_x && to.x == box_.high_x && from.y < to.y) ||
         (from.y == box_.high_y && to.y == box_.high_y && from.x > to.x) ||
         (from.x == box_.low_x && to.x == box_.low_x && from.y > to.y);
}

bool BoxSides::set_chords(std::vector<HalfPlane>& chords) const {
  struct Side {
    RealVec from, to;  // counter-clockwise
  };
  std::array<Side, 4> sides;
  std::size_t count = 0;
  if (!bottom_.is_empty()) sides[count++] = {{bottom_.least, box_.low_y}, {bottom_.most, box_.low_y}};
  if (!right_.is_empty()) sides[count++] = {{box_.high_x, right_.least}, {box_.high_x, right_.most}};
  if (!top_.is_empty()) sides[count++] = {{top_.most, box_.high_y}, {top_.least, box_.high_y}};
  if (!left_.is_empty()) sides[count++] = {{box_.low_x, left_.most}, {box_.low_x, left_.least}};
  chords.clear();
  for (std::size_t k = 0; k < count; ++k) {
    const RealVec from = sides[k].to;
    const RealVec to = sides[k + 1 < count ? k + 1 : 0].from;
    if (is_along(from, to)) continue;
    const double x = to.x - from.x;
    const double y = to.y - from.y;
    const double length = std::hypot(x, y);
    if (length == 0) return false;
    chords.push_back({-y / length, x / length, (-y * from.x + x * from.y) / length});
  }
  return count > 1;
}

}  // namespace selvage::packing::cells
