#include "protocol/formats/label_spot.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace selvage {
namespace {

struct Point {
  double x{}, y{};
};

double distance_to_edge(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// The distance to the boundary, negative outside.
double clearance(Point p, const std::vector<Point>& outline) {
  bool inside = false;
  double nearest = INFINITY;
  Point a = outline.back();
  for (const Point b : outline) {
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    nearest = std::min(nearest, distance_to_edge(p, a, b));
    a = b;
  }
  return inside ? nearest : -nearest;
}

struct Spot {
  Point at;
  double radius = -INFINITY;
};

// The roomiest point: a grid over the box, then finer grids round the best point so far.
Spot roomiest(const std::vector<Point>& outline) {
  constexpr int kSteps = 10, kRefinements = 4;
  Point low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const Point p : outline) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  Spot best;
  Point centre{(low.x + high.x) / 2, (low.y + high.y) / 2};
  double half_width = (high.x - low.x) / 2, half_height = (high.y - low.y) / 2;
  for (int round = 0; round <= kRefinements; ++round) {
    for (int i = -kSteps; i <= kSteps; ++i) {
      for (int j = -kSteps; j <= kSteps; ++j) {
        const Point p{centre.x + half_width * i / kSteps, centre.y + half_height * j / kSteps};
        const double radius = clearance(p, outline);
        if (radius > best.radius) best = {p, radius};
      }
    }
    centre = best.at;
    half_width *= 2.0 / kSteps;
    half_height *= 2.0 / kSteps;
  }
  return best;
}

// In coordinates squeezed along the text, a label is a square, and the largest one sits in the largest
// circle.
Spot roomiest_squeezed(const Polygon& outline, double squeeze_x, double squeeze_y) {
  std::vector<Point> squeezed;
  squeezed.reserve(outline.size());
  for (const Vec v : outline) {
    squeezed.push_back({static_cast<double>(v.x) / squeeze_x, static_cast<double>(v.y) / squeeze_y});
  }
  Spot spot = roomiest(squeezed);
  spot.at = {spot.at.x * squeeze_x, spot.at.y * squeeze_y};
  return spot;
}

}  // namespace

LabelSpot find_label_spot(const Polygon& outline, double aspect) {
  constexpr double kPreferLevel = 1.4;  // upright text must be this much larger to be worth the turned head
  constexpr double kSquareInCircle = 0.70710678;
  const Spot level = roomiest_squeezed(outline, aspect, 1);
  const Spot upright = roomiest_squeezed(outline, 1, aspect);
  const bool turn = upright.radius > kPreferLevel * level.radius;
  const Spot& best = turn ? upright : level;
  return {best.at.x, best.at.y, std::max(0.0, best.radius * kSquareInCircle), turn};
}

}  // namespace selvage
