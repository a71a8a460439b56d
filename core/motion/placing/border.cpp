#include "core/motion/placing/border.h"

#include <algorithm>
#include <cmath>

namespace selvage::motion::placing {
namespace {

constexpr double kRounding = 2;  // lattice units by which lines are extended against rounding

void append_edge_and_edge(const BorderLine& p, const BorderLine& q, std::vector<RealVec>& points) {
  const double px = p.b.x - p.a.x;
  const double py = p.b.y - p.a.y;
  const double qx = q.b.x - q.a.x;
  const double qy = q.b.y - q.a.y;
  const double turn = px * qy - py * qx;
  const double p_length = std::hypot(px, py);
  const double q_length = std::hypot(qx, qy);
  if (std::abs(turn) <= 1e-12 * p_length * q_length) return;
  const double sx = q.a.x - p.a.x;
  const double sy = q.a.y - p.a.y;
  const double t = (sx * qy - sy * qx) / turn;
  const double u = (sx * py - sy * px) / turn;
  if (t * p_length < -kRounding || (t - 1) * p_length > kRounding) return;
  if (u * q_length < -kRounding || (u - 1) * q_length > kRounding) return;
  points.push_back({p.a.x + t * px, p.a.y + t * py});
}

void append_edge_and_arc(const BorderLine& edge, const BorderLine& arc, std::vector<RealVec>& points) {
  const double length = std::hypot(edge.b.x - edge.a.x, edge.b.y - edge.a.y);
  const double ux = (edge.b.x - edge.a.x) / length;
  const double uy = (edge.b.y - edge.a.y) / length;
  const double along = (arc.a.x - edge.a.x) * ux + (arc.a.y - edge.a.y) * uy;
  const double off = (arc.a.x - edge.a.x) * uy - (arc.a.y - edge.a.y) * ux;
  const double square = arc.radius * arc.radius - off * off;
  if (square < 0) return;
  for (const double t : {along - std::sqrt(square), along + std::sqrt(square)}) {
    if (t >= -kRounding && t <= length + kRounding) points.push_back({edge.a.x + t * ux, edge.a.y + t * uy});
  }
}

void append_arc_and_arc(const BorderLine& p, const BorderLine& q, std::vector<RealVec>& points) {
  const double dx = q.a.x - p.a.x;
  const double dy = q.a.y - p.a.y;
  const double square = dx * dx + dy * dy;
  if (square == 0) return;
  const double t = 0.5 + (p.radius * p.radius - q.radius * q.radius) / (2 * square);
  const double across = p.radius * p.radius / square - t * t;
  if (across < 0) return;
  for (const double u : {-std::sqrt(across), std::sqrt(across)}) {
    points.push_back({p.a.x + t * dx - u * dy, p.a.y + t * dy + u * dx});
  }
}

}  // namespace

RealVec nearest_in(const RealBox& box, RealVec point) {
  return {std::clamp(point.x, box.low_x, box.high_x), std::clamp(point.y, box.low_y, box.high_y)};
}
bool holds(const RealBox& box, RealVec point, double margin) {
  return point.x >= box.low_x - margin && point.x <= box.high_x + margin && point.y >= box.low_y - margin &&
         point.y <= box.high_y + margin;
}

double squared_distance(RealVec p, RealVec q) {
  return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}
double distance_between(Vec p, Vec q) {
  return std::hypot(static_cast<double>(p.x - q.x), static_cast<double>(p.y - q.y));
}

RealVec nearest_on(const BorderLine& line, RealVec point) {
  if (line.arc()) {
    const RealVec out = outwards(line, point);
    const double radius = line.free_disc ? -line.radius : line.radius;
    return {line.a.x + radius * out.x, line.a.y + radius * out.y};
  }
  const double dx = line.b.x - line.a.x;
  const double dy = line.b.y - line.a.y;
  const double square = dx * dx + dy * dy;
  const double along = (point.x - line.a.x) * dx + (point.y - line.a.y) * dy;
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  return {line.a.x + t * dx, line.a.y + t * dy};
}

bool enters(const BorderLine& line, const RealBox& box) {
  if (line.arc()) {
    const double nearest = squared_distance(nearest_in(box, line.a), line.a);
    const double x = std::max(std::abs(box.low_x - line.a.x), std::abs(box.high_x - line.a.x)) + kRounding;
    const double y = std::max(std::abs(box.low_y - line.a.y), std::abs(box.high_y - line.a.y)) + kRounding;
    const double reach = line.radius + kRounding;
    return nearest <= reach * reach && x * x + y * y >= line.radius * line.radius;
  }
  if (std::max(line.a.x, line.b.x) < box.low_x - kRounding || std::min(line.a.x, line.b.x) > box.high_x + kRounding ||
      std::max(line.a.y, line.b.y) < box.low_y - kRounding || std::min(line.a.y, line.b.y) > box.high_y + kRounding) {
    return false;
  }
  const double dx = line.b.x - line.a.x;
  const double dy = line.b.y - line.a.y;
  const double middle = dx * (box.middle_y() - line.a.y) - dy * (box.middle_x() - line.a.x);
  const double half = std::abs(dx) * (box.height() / 2 + kRounding) + std::abs(dy) * (box.width() / 2 + kRounding);
  return std::abs(middle) <= half;
}

void append_crossings(const BorderLine& p, const BorderLine& q, std::vector<RealVec>& points) {
  if (p.arc() && q.arc()) return append_arc_and_arc(p, q, points);
  if (p.arc()) return append_edge_and_arc(q, p, points);
  if (q.arc()) return append_edge_and_arc(p, q, points);
  append_edge_and_edge(p, q, points);
}

RealVec outwards(const BorderLine& line, RealVec at) {
  const double x = line.arc() ? at.x - line.a.x : line.b.y - line.a.y;
  const double y = line.arc() ? at.y - line.a.y : line.a.x - line.b.x;
  const double length = line.free_disc ? -std::hypot(x, y) : std::hypot(x, y);
  return length != 0 ? RealVec{x / length, y / length} : RealVec{1, 0};
}

}  // namespace selvage::motion::placing
