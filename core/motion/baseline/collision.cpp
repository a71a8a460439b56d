#include "core/motion/baseline/collision.h"

#include <algorithm>
#include <cmath>

#include "core/minkowski/edges_near.h"

namespace selvage::motion::baseline {
namespace {

// Lattice units by which a corner is hit later than an edge, so that a piece that slides past a corner at exactly the
// clearance does not hit it.
constexpr double kGrazing = 0.5;
constexpr double kStandstill = 1e-12;  // slower approaches are only rounding

// One edge, in coordinates whose origin is the moving point.
struct Ahead {
  double ax{}, ay{}, bx{}, by{};  // its ends
  double ux{}, uy{};              // its line's unit direction
  double outside_by{};            // the distance of the point outside its line
};

Ahead seen_from(const minkowski::convolution::SumEdge& edge, Vec at, double rest_x, double rest_y) {
  Ahead ahead{static_cast<double>(edge.from.x - at.x) - rest_x, static_cast<double>(edge.from.y - at.y) - rest_y,
              static_cast<double>(edge.to.x - at.x) - rest_x, static_cast<double>(edge.to.y - at.y) - rest_y};
  const Vec along = edge.line_to - edge.line_from;
  const double length = std::hypot(static_cast<double>(along.x), static_cast<double>(along.y));
  ahead.ux = static_cast<double>(along.x) / length;
  ahead.uy = static_cast<double>(along.y) / length;
  ahead.outside_by =
      -static_cast<double>(cross(along, at - edge.line_from)) / length + ahead.uy * rest_x - ahead.ux * rest_y;
  return ahead;
}

double distance_to(const Ahead& e) {
  const double dx = e.bx - e.ax;
  const double dy = e.by - e.ay;
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(-(e.ax * dx + e.ay * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(e.ax + t * dx, e.ay + t * dy);
}

// The time until the point is within `radius` of the corner (cx, cy); infinity when it already is.
double time_to_corner(double cx, double cy, double vx, double vy, double radius) {
  const double speed = vx * vx + vy * vy;
  const double towards = cx * vx + cy * vy;
  const double beyond = cx * cx + cy * cy - radius * radius;
  const double root = towards * towards - speed * beyond;
  if (radius <= 0 || towards <= 0 || beyond <= 0 || root <= 0) return lp::kInfinity;
  return (towards - std::sqrt(root)) / speed;
}

double time_to_edge(const Ahead& e, double vx, double vy, double clearance) {
  const double approach = -(e.uy * vx - e.ux * vy);  // the outward normal is (uy, -ux)
  double time = std::min(time_to_corner(e.ax, e.ay, vx, vy, clearance - kGrazing),
                         time_to_corner(e.bx, e.by, vx, vy, clearance - kGrazing));
  if (e.outside_by < 0 || approach <= kStandstill) return time;
  // In front of the edge, from where it begins to where it ends: coming along another edge into a corner, the point may
  // be within the clearance of the line before that.
  const double along = e.ux * vx + e.uy * vy;
  const double first = e.ux * e.ax + e.uy * e.ay;
  const double last = e.ux * e.bx + e.uy * e.by;
  double enters = std::max(0.0, (e.outside_by - clearance) / approach);
  double leaves = e.outside_by / approach;
  if (along != 0) {
    enters = std::max(enters, std::min(first / along, last / along));
    leaves = std::min(leaves, std::max(first / along, last / along));
  } else if (first > 0 || last < 0) {
    return time;
  }
  if (enters <= leaves) time = std::min(time, enters);
  return time;
}

}  // namespace

double collision_time(const minkowski::Obstacle& obstacle, const FinePosition& r, const RealVec& velocity,
                      const CollisionSettings& settings) {
  if (velocity.x == 0 && velocity.y == 0) return settings.horizon;
  const Vec at = obstacle.to_frame(r.at);
  const auto rest = obstacle.direction_to_frame(r.rest.x, r.rest.y);
  const auto speed = obstacle.direction_to_frame(velocity.x, velocity.y);
  const Vec end{at.x + std::llround(speed.first * settings.horizon),
                at.y + std::llround(speed.second * settings.horizon)};
  const Box path =
      Box{{std::min(at.x, end.x), std::min(at.y, end.y)}, {std::max(at.x, end.x), std::max(at.y, end.y)}}.grown(
          static_cast<Coord>(std::ceil(settings.touching)) + 1);
  double time = settings.horizon;
  for_each_edge_near(obstacle.sum(), path, [&](const minkowski::convolution::SumEdge& edge) {
    const Ahead ahead = seen_from(edge, at, rest.first, rest.second);
    if (distance_to(ahead) > settings.touching)
      time = std::min(time, time_to_edge(ahead, speed.first, speed.second, settings.clearance));
  });
  return time;
}

}  // namespace selvage::motion::baseline
