#include "core/minkowski/ring.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/pseudo_angle.h"

namespace selvage {
namespace {

double angle_of(double x, double y) { return x == 0 && y == 0 ? 0 : pseudo_angle(x, y); }

}  // namespace

Ring::Ring(const StarSum& sum) : centre_{sum.centre} {
  corners_.reserve(sum.edges.size());
  for (const SumEdge& e : sum.edges) {
    const double x = static_cast<double>(e.from.x) - centre_.x;
    const double y = static_cast<double>(e.from.y) - centre_.y;
    const auto dx = static_cast<double>(e.to.x - e.from.x);
    const auto dy = static_cast<double>(e.to.y - e.from.y);
    const double length = std::hypot(dx, dy);
    corners_.push_back({angle_of(x, y), x, y, dx / length, dy / length});
  }
  const auto first = std::min_element(corners_.begin(), corners_.end(),
                                      [](const Corner& a, const Corner& b) { return a.angle < b.angle; });
  std::rotate(corners_.begin(), first, corners_.end());
}

std::size_t Ring::corner_before(double angle) const {
  const auto after = std::upper_bound(corners_.begin(), corners_.end(), angle,
                                      [](double value, const Corner& c) { return value < c.angle; });
  return after == corners_.begin() ? corners_.size() - 1 : static_cast<std::size_t>(after - corners_.begin()) - 1;
}

bool Ring::holds(Real2 point, double margin) const {
  const double x = point.x - centre_.x;
  const double y = point.y - centre_.y;
  return depth(corners_[corner_before(angle_of(x, y))], x, y) > margin;
}

void Ring::append_inside(Real2 a, Real2 b, double margin, std::vector<std::pair<double, double>>& stretches) const {
  const double ax = a.x - centre_.x;
  const double ay = a.y - centre_.y;
  const double bx = b.x - centre_.x;
  const double by = b.y - centre_.y;
  const double turn = ax * by - ay * bx;
  const double length = std::hypot(bx - ax, by - ay);
  if (std::abs(turn) <= margin * length) {
    append_radial(ax, ay, bx, by, margin, stretches);
  } else if (turn > 0) {
    append_turning(ax, ay, bx, by, false, margin, stretches);
  } else {
    append_turning(bx, by, ax, ay, true, margin, stretches);
  }
}

// The segment turns counter-clockwise about the centre: walk the edges that face it one after another.
void Ring::append_turning(double ax, double ay, double bx, double by, bool reversed, double margin,
                          std::vector<std::pair<double, double>>& stretches) const {
  const std::size_t n = corners_.size();
  const double dx = bx - ax;
  const double dy = by - ay;
  const auto add = [&](double t0, double t1) {
    if (t1 <= t0) return;
    stretches.emplace_back(reversed ? 1 - t1 : t0, reversed ? 1 - t0 : t1);
  };
  const double end = angle_of(bx, by);
  std::size_t k = corner_before(angle_of(ax, ay));
  double t = 0;
  double left = angle_of(ax, ay);
  for (std::size_t step = 0; step <= n && t < 1; ++step, k = k + 1 == n ? 0 : k + 1) {
    const Corner& next = corners_[k + 1 == n ? 0 : k + 1];
    // How far along the segment the next corner's ray is, if the segment gets there.
    const double to_end = end >= left ? end - left : end - left + kFullTurn;
    const double to_next = next.angle > left || n == 1 ? next.angle - left : next.angle - left + kFullTurn;
    double t_next = 1;
    if (to_next < to_end) {
      const double across = next.x * dy - next.y * dx;
      const double at = across == 0 ? t : (next.y * ax - next.x * ay) / across;
      t_next = std::clamp(at, t, 1.0);
    }
    const double here = depth(corners_[k], ax + t * dx, ay + t * dy) - margin;
    const double there = depth(corners_[k], ax + t_next * dx, ay + t_next * dy) - margin;
    if (here > 0 && there > 0) {
      add(t, t_next);
    } else if (here > 0 || there > 0) {
      const double cut = t + (t_next - t) * here / (here - there);
      if (here > 0) add(t, cut);
      else add(cut, t_next);
    }
    if (to_next >= to_end) return;
    t = t_next;
    left = next.angle;
  }
}

// The segment lies on a line through the centre: inside as far as the edge on either side of the centre allows.
void Ring::append_radial(double ax, double ay, double bx, double by, double margin,
                         std::vector<std::pair<double, double>>& stretches) const {
  const double a_depth = depth(corners_[corner_before(angle_of(ax, ay))], ax, ay) - margin;
  const double b_depth = depth(corners_[corner_before(angle_of(bx, by))], bx, by) - margin;
  if (a_depth > 0 && b_depth > 0) {
    stretches.emplace_back(0.0, 1.0);
    return;
  }
  const double dx = bx - ax;
  const double dy = by - ay;
  const double nearest = std::clamp(-(ax * dx + ay * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const double mx = ax + nearest * dx;
  const double my = ay + nearest * dy;
  const Corner& a_corner = corners_[corner_before(angle_of(ax, ay))];
  const Corner& b_corner = corners_[corner_before(angle_of(bx, by))];
  const double middle_a = depth(a_corner, mx, my) - margin;
  const double middle_b = depth(b_corner, mx, my) - margin;
  if (middle_a > 0) {
    const double from = a_depth > 0 ? 0.0 : nearest * a_depth / (a_depth - middle_a);
    if (nearest > from) stretches.emplace_back(from, nearest);
  }
  if (middle_b > 0) {
    const double to = b_depth > 0 ? 1.0 : nearest + (1 - nearest) * middle_b / (middle_b - b_depth);
    if (to > nearest) stretches.emplace_back(nearest, to);
  }
}

}  // namespace selvage
