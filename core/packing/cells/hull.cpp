#include "core/packing/cells/hull.h"

#include <algorithm>
#include <cmath>

namespace selvage::packing::cells {
namespace {

constexpr double kAlongAxis = 1e-9;  // a unit normal this near to an axis
constexpr double kShortest = 1;      // shorter hull edges are left out: lattice units

double turn(RealVec a, RealVec b, RealVec c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_along_axis(const HalfPlane& plane) {
  return std::abs(plane.nx) < kAlongAxis || std::abs(plane.ny) < kAlongAxis;
}

void append_plane(RealVec from, RealVec to, std::vector<HalfPlane>& planes) {
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  const double length = std::hypot(x, y);
  if (length < kShortest) return;
  const double nx = -y / length;
  const double ny = x / length;
  append_side({nx, ny, nx * from.x + ny * from.y - kRounding}, planes);
}

}  // namespace

void append_side(const HalfPlane& plane, std::vector<HalfPlane>& planes) {
  if (!is_along_axis(plane)) planes.push_back(plane);
}

void append_hull(std::vector<RealVec>& points, std::vector<HalfPlane>& planes) {
  std::sort(points.begin(), points.end(), [](RealVec a, RealVec b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<RealVec> chain(points.size() + 1);
  const auto append_chain = [&](auto begin, auto end) {
    std::size_t count = 0;
    for (auto p = begin; p != end; ++p) {
      while (count >= 2 && turn(chain[count - 2], chain[count - 1], *p) <= 0) --count;
      chain[count++] = *p;
    }
    for (std::size_t k = 0; k + 1 < count; ++k) append_plane(chain[k], chain[k + 1], planes);
  };
  append_chain(points.begin(), points.end());
  append_chain(points.rbegin(), points.rend());
}

}  // namespace selvage::packing::cells
