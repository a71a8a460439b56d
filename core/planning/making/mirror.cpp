#include "core/planning/making/mirror.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace selvage::planning::making {
namespace {

struct Point {
  double x{}, y{};
};

// About the centre of its box.
std::vector<Point> centred(const Polygon& polygon) {
  const Box box = geometry::box_of(polygon);
  const double x = static_cast<double>(box.low.x + box.high.x) / 2, y = static_cast<double>(box.low.y + box.high.y) / 2;
  std::vector<Point> points;
  for (const Vec vertex : polygon)
    points.push_back({static_cast<double>(vertex.x) - x, static_cast<double>(vertex.y) - y});
  return points;
}

double distance_to_edge(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(a.x + t * dx - p.x, a.y + t * dy - p.y);
}

bool lie_on(const std::vector<Point>& points, const std::vector<Point>& outline, double slack) {
  return std::all_of(points.begin(), points.end(), [&](Point p) {
    for (std::size_t k = 0; k < outline.size(); ++k) {
      if (distance_to_edge(p, outline[k], outline[(k + 1) % outline.size()]) <= slack) return true;
    }
    return false;
  });
}

}  // namespace

bool are_mirror_images(const Polygon& a, const Polygon& b, double slack) {
  const std::vector<Point> target = centred(b);
  for (const double turn : {1.0, -1.0}) {
    std::vector<Point> image = centred(a);
    for (Point& point : image) point = {turn * point.x, -turn * point.y};
    if (lie_on(image, target, slack) && lie_on(target, image, slack)) return true;
  }
  return false;
}

}  // namespace selvage::planning::making
