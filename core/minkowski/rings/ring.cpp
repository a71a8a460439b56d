#include "core/minkowski/rings/ring.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/pseudo_angle.h"

namespace selvage::minkowski::rings {
namespace {

double angle_of(double x, double y) {
  return x == 0 && y == 0 ? 0 : geometry::pseudo_angle(x, y);
}

// True when both edges lie on the same exact line with the same direction.
bool run_along(const convolution::SumEdge& e, const convolution::SumEdge& f) {
  const Vec along = e.line_to - e.line_from;
  const Vec other = f.line_to - f.line_from;
  return cross(along, other) == 0 && cross(along, f.line_from - e.line_from) == 0 && dot(along, other) > 0;
}

}  // namespace

bool holds(const convolution::StarSum& sum, RealVec point, double margin) {
  const auto angle_to = [&](RealVec to) { return angle_of(to.x - sum.centre.x, to.y - sum.centre.y); };
  const double first = angle_to(real(sum.edges.front().from));
  const auto turned = [&](RealVec to) {  // from the first corner, counter-clockwise
    const double angle = angle_to(to) - first;
    return angle < 0 ? angle + geometry::kFullTurn : angle;
  };
  const auto after =
      std::upper_bound(sum.edges.begin() + 1, sum.edges.end(), turned(point),
                       [&](double angle, const convolution::SumEdge& edge) { return angle < turned(real(edge.from)); });
  const convolution::SumEdge& facing = *(after - 1);
  const RealVec along = real(facing.line_to - facing.line_from);
  const RealVec from = real(facing.from);
  const double across = along.x * (point.y - from.y) - along.y * (point.x - from.x);
  return across > margin * std::hypot(along.x, along.y);
}

Ring::Ring(const convolution::StarSum& sum) : centre_{sum.centre} {
  corners_.reserve(sum.edges.size());
  for (const convolution::SumEdge& e : sum.edges) {
    const double x = static_cast<double>(e.from.x) - centre_.x;
    const double y = static_cast<double>(e.from.y) - centre_.y;
    const auto dx = static_cast<double>(e.line_to.x - e.line_from.x);
    const auto dy = static_cast<double>(e.line_to.y - e.line_from.y);
    const double length = std::sqrt(dx * dx + dy * dy);
    corners_.push_back({angle_of(x, y), x, y, dx / length, dy / length, &e});
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

void Ring::append_inside(const convolution::SumEdge& edge, double margin, bool own_edges, Stretches& stretches) const {
  Question question{static_cast<double>(edge.from.x) - centre_.x,
                    static_cast<double>(edge.from.y) - centre_.y,
                    static_cast<double>(edge.to.x) - centre_.x,
                    static_cast<double>(edge.to.y) - centre_.y,
                    &edge,
                    margin,
                    own_edges,
                    false};
  const double turn = question.ax * question.by - question.ay * question.bx;
  const double length = std::abs(question.bx - question.ax) + std::abs(question.by - question.ay);
  if (std::abs(turn) <= margin * length) {
    append_radial(question, stretches);
    return;
  }
  if (turn < 0) {
    std::swap(question.ax, question.bx);
    std::swap(question.ay, question.by);
    question.reversed = true;
  }
  append_turning(question, stretches);
}

double Ring::margin_at(const Corner& corner, const Question& question) const {
  constexpr double kRoundedEnds =
      2;  // two rounded end points of edges on one line can appear up to this far off the other edge
  if (question.reversed) return question.margin;
  const double dx = question.bx - question.ax;
  const double dy = question.by - question.ay;
  const bool nearly_parallel = std::abs(corner.dx * dy - corner.dy * dx) <= kRoundedEnds;
  if (!nearly_parallel || !run_along(*corner.edge, *question.edge)) return question.margin;
  return question.own_edges ? -kRoundedEnds : kRoundedEnds;
}

// The segment turns counter-clockwise about the centre: go through the edges that face it in order.
void Ring::append_turning(const Question& question, Stretches& stretches) const {
  const std::size_t n = corners_.size();
  const double ax = question.ax;
  const double ay = question.ay;
  const double dx = question.bx - ax;
  const double dy = question.by - ay;
  const auto add = [&](double t0, double t1) {
    if (t1 <= t0) return;
    stretches.emplace_back(question.reversed ? 1 - t1 : t0, question.reversed ? 1 - t0 : t1);
  };
  const double end = angle_of(question.bx, question.by);
  double left = angle_of(ax, ay);
  std::size_t k = corner_before(left);
  double t = 0;
  for (std::size_t step = 0; step <= n && t < 1; ++step, k = k + 1 == n ? 0 : k + 1) {
    const Corner& next = corners_[k + 1 == n ? 0 : k + 1];
    // The parameter at which the segment crosses the ray through the next corner, if it reaches that ray.
    const double to_end = end >= left ? end - left : end - left + geometry::kFullTurn;
    const double to_next = next.angle > left ? next.angle - left : next.angle - left + geometry::kFullTurn;
    double t_next = 1;
    if (to_next < to_end) {
      const double across = next.x * dy - next.y * dx;
      const double at = across == 0 ? t : (next.y * ax - next.x * ay) / across;
      t_next = std::clamp(at, t, 1.0);
    }
    const double margin = margin_at(corners_[k], question);
    const double here = depth(corners_[k], ax + t * dx, ay + t * dy) - margin;
    const double there = depth(corners_[k], ax + t_next * dx, ay + t_next * dy) - margin;
    if (here > 0 && there > 0) {
      add(t, t_next);
    } else if (here > 0 || there > 0) {
      const double cut = t + (t_next - t) * here / (here - there);
      add(here > 0 ? t : cut, here > 0 ? cut : t_next);
    }
    if (to_next >= to_end) return;
    t = t_next;
    left = next.angle;
  }
}

// The segment lies on a line through the centre: on either side of the centre, a single edge bounds the inside.
void Ring::append_radial(const Question& question, Stretches& stretches) const {
  const double ax = question.ax;
  const double ay = question.ay;
  const double dx = question.bx - ax;
  const double dy = question.by - ay;
  const double middle = std::clamp(-(ax * dx + ay * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const auto depth_at = [&](const Corner& corner, double t) {
    return depth(corner, ax + t * dx, ay + t * dy) - question.margin;
  };
  const Corner& towards_a = corners_[corner_before(angle_of(ax, ay))];
  const Corner& towards_b = corners_[corner_before(angle_of(question.bx, question.by))];
  if (const double inner = depth_at(towards_a, middle); inner > 0 && middle > 0) {
    const double outer = depth_at(towards_a, 0);
    stretches.emplace_back(outer > 0 ? 0.0 : middle * outer / (outer - inner), middle);
  }
  if (const double inner = depth_at(towards_b, middle); inner > 0 && middle < 1) {
    const double outer = depth_at(towards_b, 1);
    stretches.emplace_back(middle, outer > 0 ? 1.0 : middle + (1 - middle) * inner / (inner - outer));
  }
}

}  // namespace selvage::minkowski::rings
