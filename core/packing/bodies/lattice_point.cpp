#include "core/packing/bodies/lattice_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace selvage::packing::bodies {
namespace {

using cells::HalfPlane;

constexpr double kFarthest = 4096;   // lattice units along each axis
constexpr double kRounding = 1e-4;   // lattice units
constexpr double kAlongAxis = 1e-9;  // a part of a unit normal

// The point of the column at `x` whose y is nearest to that of `from`.
std::optional<RealVec> in_column(double x, RealVec from, std::span<const HalfPlane> planes, const RealBox& box) {
  double low = box.low_y;
  double high = box.high_y;
  for (const HalfPlane& plane : planes) {
    const double rest = plane.c - plane.nx * x - kRounding;
    if (plane.ny > kAlongAxis) low = std::max(low, rest / plane.ny);
    if (plane.ny < -kAlongAxis) high = std::min(high, rest / plane.ny);
    if (std::abs(plane.ny) <= kAlongAxis && rest > 0) return std::nullopt;
  }
  low = std::ceil(low);
  high = std::floor(high);
  if (low > high) return std::nullopt;
  return RealVec{x, std::clamp(std::round(from.y), low, high)};
}

std::optional<RealVec> in_columns(RealVec from, std::span<const HalfPlane> planes, const RealBox& box) {
  const double middle = std::round(from.x);
  const double farthest = std::max(middle - box.low_x, box.high_x - middle);
  for (double away = 0; away <= farthest; ++away) {
    for (const double x : {middle + away, middle - away}) {
      if (x < box.low_x || x > box.high_x) continue;
      if (const auto point = in_column(x, from, planes, box)) return point;
    }
  }
  return std::nullopt;
}

// The box of the points of a box in all half-planes, beyond which they may lie by twice the rounding; empty (high <
// low) when there are none.
RealBox box_of_common(std::span<const HalfPlane> planes, const RealBox& box) {
  std::vector<RealVec> corners{
      {box.low_x, box.low_y}, {box.high_x, box.low_y}, {box.high_x, box.high_y}, {box.low_x, box.high_y}};
  std::vector<RealVec> kept;
  for (const HalfPlane& plane : planes) {
    kept.clear();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const RealVec p = corners[k];
      const RealVec q = corners[(k + 1) % corners.size()];
      const double room_p = plane.room(p) + 2 * kRounding;
      const double room_q = plane.room(q) + 2 * kRounding;
      if (room_p >= 0) kept.push_back(p);
      if ((room_p >= 0) == (room_q >= 0)) continue;
      const double t = room_p / (room_p - room_q);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
    corners.swap(kept);
  }
  RealBox common{box.high_x, box.high_y, box.low_x, box.low_y};
  for (const RealVec corner : corners) {
    common = {std::min(common.low_x, corner.x), std::min(common.low_y, corner.y), std::max(common.high_x, corner.x),
              std::max(common.high_y, corner.y)};
  }
  return {std::max(std::floor(common.low_x), box.low_x), std::max(std::floor(common.low_y), box.low_y),
          std::min(std::ceil(common.high_x), box.high_x), std::min(std::ceil(common.high_y), box.high_y)};
}

RealVec mirrored(RealVec p) {
  return {p.y, p.x};
}

}  // namespace

std::optional<RealVec> lattice_point_near(RealVec from, std::span<const HalfPlane> planes, const RealBox& box) {
  const RealBox near{std::max(box.low_x, from.x - kFarthest), std::max(box.low_y, from.y - kFarthest),
                     std::min(box.high_x, from.x + kFarthest), std::min(box.high_y, from.y + kFarthest)};
  std::vector<HalfPlane> along;
  std::vector<HalfPlane> across;
  for (const HalfPlane& plane : planes) {
    if (plane.room(from) > 2 * kFarthest) continue;
    along.push_back(plane);
    across.push_back({plane.ny, plane.nx, plane.c});
  }
  const RealBox common = box_of_common(along, near);
  if (common.low_x > common.high_x) return std::nullopt;
  if (const auto point = in_columns(from, along, common)) return point;
  const auto point = in_columns(mirrored(from), across, {common.low_y, common.low_x, common.high_y, common.high_x});
  return point ? std::optional{mirrored(*point)} : std::nullopt;
}

}  // namespace selvage::packing::bodies
