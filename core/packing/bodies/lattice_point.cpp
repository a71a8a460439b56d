#include "core/packing/bodies/lattice_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace selvage::packing::bodies {
namespace {

using cells::HalfPlane;
using cells::RealBox;

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
  for (double away = 0; away <= kFarthest; ++away) {
    for (const double x : {middle + away, middle - away}) {
      if (x < box.low_x || x > box.high_x) continue;
      if (const auto point = in_column(x, from, planes, box)) return point;
    }
  }
  return std::nullopt;
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
  if (const auto point = in_columns(from, along, near)) return point;
  const auto point = in_columns(mirrored(from), across, {near.low_y, near.low_x, near.high_y, near.high_x});
  return point ? std::optional{mirrored(*point)} : std::nullopt;
}

}  // namespace selvage::packing::bodies
