#include "protocol/drawing/label_spot.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace selvage::protocol::drawing {
namespace {

struct Point {
  double x{}, y{};
};

double squared_distance_to_edge(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0.0;
  const double off_x = p.x - a.x - t * dx, off_y = p.y - a.y - t * dy;
  return off_x * off_x + off_y * off_y;
}

using Rings = std::vector<std::vector<Point>>;  // the outline, then its holes

// The distance to the boundary, negative outside and in holes.
double clearance(Point p, const Rings& rings) {
  bool inside = false;
  double nearest = INFINITY;
  for (const std::vector<Point>& ring : rings) {
    Point a = ring.back();
    for (const Point b : ring) {
      if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
      nearest = std::min(nearest, squared_distance_to_edge(p, a, b));
      a = b;
    }
  }
  return inside ? std::sqrt(nearest) : -std::sqrt(nearest);
}

Point centroid(const std::vector<Point>& outline) {
  double area = 0;
  Point sum;
  const Point origin = outline.front();
  for (std::size_t i = 2; i < outline.size(); ++i) {
    const Point a = outline[i - 1], b = outline[i];
    const double part = (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
    area += part;
    sum = {sum.x + part * (origin.x + a.x + b.x) / 3, sum.y + part * (origin.y + a.y + b.y) / 3};
  }
  return {sum.x / area, sum.y / area};
}

struct Candidate {
  Point at;
  double radius = -INFINITY;
  double off_centre = INFINITY;
};

// Prefers more room up to `enough`, then a spot nearer to the middle.
bool better(const Candidate& a, const Candidate& b, double enough) {
  const double room_a = std::min(a.radius, enough), room_b = std::min(b.radius, enough);
  return room_a != room_b ? room_a > room_b : a.off_centre < b.off_centre;
}

// Searches a grid over the box, then finer grids around the best point so far.
Candidate best_spot(const Rings& rings, double enough) {
  constexpr int kSteps = 6, kRefinements = 4;
  Point low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const Point p : rings.front()) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Point middle = centroid(rings.front());
  Candidate best;
  Point centre{(low.x + high.x) / 2, (low.y + high.y) / 2};
  double half_width = (high.x - low.x) / 2, half_height = (high.y - low.y) / 2;
  for (int round = 0; round <= kRefinements; ++round) {
    for (int i = -kSteps; i <= kSteps; ++i) {
      for (int j = -kSteps; j <= kSteps; ++j) {
        const Point p{centre.x + half_width * i / kSteps, centre.y + half_height * j / kSteps};
        const Candidate spot{p, clearance(p, rings), std::hypot(p.x - middle.x, p.y - middle.y)};
        if (better(spot, best, enough)) best = spot;
      }
    }
    centre = best.at;
    half_width *= 2.0 / kSteps;
    half_height *= 2.0 / kSteps;
  }
  return best;
}

// In coordinates squeezed along the text a label is a square, and a square fits into a circle.
Candidate best_squeezed(const Polygon& outline, const std::vector<Polygon>& holes, Point squeeze, double enough) {
  constexpr std::size_t kEnoughVertices = 64;  // a rough outline will do
  Rings squeezed;
  const auto add = [&](const Polygon& polygon) {
    const std::size_t stride = polygon.size() / kEnoughVertices + 1;
    std::vector<Point>& ring = squeezed.emplace_back();
    for (std::size_t i = 0; i < polygon.size(); i += stride) {
      const Vec v = polygon[i];
      ring.push_back({static_cast<double>(v.x) / squeeze.x, static_cast<double>(v.y) / squeeze.y});
    }
  };
  add(outline);
  for (const Polygon& hole : holes) add(hole);
  Candidate spot = best_spot(squeezed, enough);
  spot.at = {spot.at.x * squeeze.x, spot.at.y * squeeze.y};
  return spot;
}

constexpr double kSquareInCircle = 0.70710678;

LabelSpot spot_of(const Candidate& spot, bool upright) {
  return {spot.at.x, spot.at.y, std::max(0.0, spot.radius * kSquareInCircle), upright};
}

}  // namespace

LabelSpot find_label_spot(const Polygon& outline, double aspect, double enough, const std::vector<Polygon>& holes) {
  constexpr double kPreferLevel = 1.4;  // text along y must be this much larger to be worth tilting one's head
  const double radius = enough / kSquareInCircle;
  const Candidate level = best_squeezed(outline, holes, {aspect, 1}, radius);
  if (kPreferLevel * level.radius >= radius) return spot_of(level, false);
  const Candidate upright = best_squeezed(outline, holes, {1, aspect}, radius);
  return upright.radius > kPreferLevel * level.radius ? spot_of(upright, true) : spot_of(level, false);
}

}  // namespace selvage::protocol::drawing
