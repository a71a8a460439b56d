#include "core/motion/repair/separation_target.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/minkowski/nearest_edges.h"
#include "core/minkowski/rings/ring.h"

namespace selvage::motion::repair {
namespace {

constexpr double kOutside = 2;  // lattice units beyond the boundary at which a region is chosen
// Lattice units.  A pair that may overlap can be refused although it is less deep than that, because of rounding.
constexpr double kLeastDepth = 1;

Vec just_outside(RealVec at, const minkowski::convolution::SumEdge& edge) {
  const Vec along = edge.line_to - edge.line_from;
  const auto dx = static_cast<double>(along.x);
  const auto dy = static_cast<double>(along.y);
  const double length = std::sqrt(dx * dx + dy * dy);
  return {std::llround(at.x + kOutside * dy / length), std::llround(at.y - kOutside * dx / length)};
}

// The centre of the first star sum that holds r: a point of its kernel.
RealVec kernel_about(const minkowski::MinkowskiSum& sum, Vec r) {
  for (const minkowski::convolution::StarSum& ring : sum.rings()) {
    if (minkowski::rings::holds(ring, real(r), 0)) return ring.centre;
  }
  return sum.rings()[0].centre;
}

// The first point beyond r of the ray from the kernel at which it leaves the sum.
std::optional<Vec> exit_of_ray(const minkowski::MinkowskiSum& sum, Vec r) {
  const RealVec kernel = kernel_about(sum, r);
  const double x = static_cast<double>(r.x) - kernel.x;
  const double y = static_cast<double>(r.y) - kernel.y;
  const minkowski::convolution::SumEdge* left_by = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const minkowski::convolution::SumEdge& edge : sum.edges()) {
    const double ax = static_cast<double>(edge.from.x - r.x);
    const double ay = static_cast<double>(edge.from.y - r.y);
    const double bx = static_cast<double>(edge.to.x - r.x);
    const double by = static_cast<double>(edge.to.y - r.y);
    const double from =
        x * ay - y * ax;  // the ray leaves over the edge when it begins to the right and ends to the left
    const double to = x * by - y * bx;
    if (from > 0 || to <= 0) continue;
    const double part = from / (from - to);
    const double beyond = ((ax + part * (bx - ax)) * x + (ay + part * (by - ay)) * y) / (x * x + y * y);
    if (beyond < 0 || beyond >= least) continue;
    least = beyond;
    left_by = &edge;
  }
  if (left_by == nullptr) return std::nullopt;
  return just_outside({static_cast<double>(r.x) + least * x, static_cast<double>(r.y) + least * y}, *left_by);
}

}  // namespace

SeparationTarget separation_target(const minkowski::Obstacle& obstacle, Vec r, bool overlapping, TargetRule rule) {
  const Vec at = obstacle.to_frame(r);
  const minkowski::BoundaryPoint nearest = nearest_boundary_point(obstacle.sum(), at);
  if (!overlapping) return {-nearest.distance, r};
  std::optional<Vec> about;
  if (rule == TargetRule::kKernelRay) about = exit_of_ray(obstacle.sum(), at);
  return {nearest.distance, obstacle.from_frame(about ? *about : just_outside(nearest.at, *nearest.edge))};
}

SeparationTarget separation_target(const scene::Scene& scene, marker::PiecePair pair, TargetRule rule) {
  const auto [p, q] = pair;
  const bool overlapping = overlap(scene.pieces.facing(p, q), scene.pieces.facing(q, p));
  SeparationTarget target = separation_target(scene.obstacle(pair), scene.relative_position(pair), overlapping, rule);
  const Coord spacing = scene.pieces.spacing(pair);
  target.depth += static_cast<double>(spacing);
  if (spacing < 0) target.depth = std::max(target.depth, kLeastDepth);
  return target;
}

}  // namespace selvage::motion::repair
