#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <boost/container/small_vector.hpp>

#include "core/minkowski/nearest_edges.h"
#include "core/model/free_region.h"

namespace selvage::model {
namespace {

constexpr double kOutside = 2;            // lattice units beyond the boundary at which a region is chosen
constexpr double kAllowanceTouching = 4;  // lattice units: edges that are as near as the nearest one
constexpr double kWidestArc = 0.5;  // radians between two points of an arc that a chord joins: it cuts off at most
                                    // 1 - cos(0.25), 3 % of the allowance
constexpr double kParallel = 1e-9;  // the sine of the least angle between lines that are intersected
constexpr double kInside = 1e-6;    // the part of the allowance by which a corner may lie outside of another line,
constexpr double kAllowanceRounding = 4;  // and lattice units: the sides of a slot that fits a piece exactly
constexpr double kDirection = 1U << 30U;  // the length of a chord's direction on the lattice

Vec beyond(RealVec at, RealVec normal) {
  return {std::llround(at.x + kOutside * normal.x), std::llround(at.y + kOutside * normal.y)};
}

RealVec normal_of(const minkowski::convolution::SumEdge& edge) {
  const RealVec along = real(edge.line_to - edge.line_from);
  const double length = std::sqrt(along.x * along.x + along.y * along.y);
  return {along.y / length, -along.x / length};
}

RealVec nearest_on(const minkowski::convolution::SumEdge& edge, Vec at) {
  const RealVec a = real(edge.from - at);
  const RealVec d = real(edge.to - edge.from);
  const double square = d.x * d.x + d.y * d.y;
  const double t = square > 0 ? std::clamp(-(a.x * d.x + a.y * d.y) / square, 0.0, 1.0) : 0;
  return {static_cast<double>(edge.from.x) + t * d.x, static_cast<double>(edge.from.y) + t * d.y};
}

// The direction that a region is to be open in; (0, 0): any.
RealVec wanted_of(const RegionSettings& settings) {
  const bool directed = settings.towards.x != 0 || settings.towards.y != 0;
  return directed ? settings.towards : settings.closing;
}

// The point just outside the sum nearest to `at`, in the sum's frame; nothing when `at` is not inside.  At a corner of
// the positions that are not allowed, where several edges are equally near, the edge that is least in the way of the
// wanted direction.
std::optional<Vec> nearest_outside(const minkowski::MinkowskiSum& sum, Vec at, Coord allowance, RealVec wanted) {
  if (!sum.contains(real(at))) return std::nullopt;
  minkowski::NearestEdges edges{sum, at, std::numeric_limits<double>::infinity()};
  const auto skip = [](const Box&) { return false; };
  auto next = edges.next(skip);
  if (!next) return std::nullopt;
  const double least = std::sqrt(next->squared_distance);
  const minkowski::convolution::SumEdge* best = next->edge;
  if (least >= static_cast<double>(allowance) - kAllowanceTouching && (wanted.x != 0 || wanted.y != 0)) {
    const auto merit = [&](const minkowski::convolution::SumEdge& edge) {
      const RealVec normal = normal_of(edge);
      return normal.x * wanted.x + normal.y * wanted.y;
    };
    while ((next = edges.next(skip)) && std::sqrt(next->squared_distance) <= least + kAllowanceTouching) {
      if (merit(*next->edge) > merit(*best)) best = next->edge;
    }
  }
  return beyond(nearest_on(*best, at), normal_of(*best));
}

// A half-plane with r as origin: inside where normal . x + slack >= 0.
struct AllowedSide {
  RealVec normal;
  double slack{};
};

double cross(RealVec a, RealVec b) {
  return a.x * b.y - a.y * b.x;
}
double dot(RealVec a, RealVec b) {
  return a.x * b.x + a.y * b.y;
}

// Adds chords of the arcs about the region's corners.
class Chords {
 public:
  Chords(std::vector<HalfPlane>& planes, const OverlappingPosition& position, double reach)
      : planes_{planes},
        r_{position.r},
        allowance_{static_cast<double>(position.allowance)},
        reach_{reach + allowance_} {
    for (const HalfPlane& plane : planes) {
      const RealVec d = real(plane.direction);
      const double length = std::sqrt(dot(d, d));
      sides_.push_back({{d.y / length, -d.x / length}, slack_of(plane, r_)});
    }
  }

  void add() {
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (const auto corner = corner_of(sides_[i], sides_[j])) add_about(*corner, sides_[i].normal, sides_[j].normal);
      }
    }
  }

 private:
  // Where two lines meet, when that is a corner of the region within reach.
  [[nodiscard]] std::optional<RealVec> corner_of(const AllowedSide& a, const AllowedSide& b) const {
    const double turn = cross(a.normal, b.normal);
    if (std::abs(turn) < kParallel) return std::nullopt;
    const RealVec at{(b.slack * a.normal.y - a.slack * b.normal.y) / turn,
                     (a.slack * b.normal.x - b.slack * a.normal.x) / turn};
    if (dot(at, at) > reach_ * reach_) return std::nullopt;
    const bool is_corner = std::all_of(sides_.begin(), sides_.end(), [&](const AllowedSide& side) {
      return dot(side.normal, at) + side.slack >= -kInside * allowance_ - kAllowanceRounding;
    });
    return is_corner ? std::optional{at} : std::nullopt;
  }

  void add_about(RealVec corner, RealVec a, RealVec b) {
    if (cross(a, b) < 0) std::swap(a, b);
    const double distance = std::sqrt(dot(corner, corner));
    const RealVec towards{corner.x / std::max(distance, 1.0), corner.y / std::max(distance, 1.0)};  // from r
    if (distance > 1 && cross(a, towards) > kParallel && cross(towards, b) > kParallel) {
      add_between(corner, a, towards);
      add_between(corner, towards, b);
    } else {
      add_between(corner, a, b);
    }
  }
  // The chords of the arc whose points are corner - allowance * u, with u from a to b counter-clockwise.
  void add_between(RealVec corner, RealVec a, RealVec b) {
    const double turn = std::atan2(cross(a, b), dot(a, b));
    const int parts = std::max(1, static_cast<int>(std::ceil(turn / kWidestArc)));
    const double half = turn / (2 * parts);
    for (int k = 0; k < parts; ++k) {
      const double angle = (2 * k + 1) * half;
      const RealVec middle{a.x * std::cos(angle) - a.y * std::sin(angle),
                           a.x * std::sin(angle) + a.y * std::cos(angle)};
      // The caller moves the line inwards by the allowance, to the chord.
      const double out = allowance_ * (1 - std::cos(half));
      const RealVec through{corner.x + out * middle.x, corner.y + out * middle.y};
      planes_.push_back({r_ + Vec{std::llround(through.x), std::llround(through.y)},
                         {-std::llround(kDirection * middle.y), std::llround(kDirection * middle.x)}});
    }
  }

  std::vector<HalfPlane>& planes_;
  Vec r_;
  double allowance_, reach_;
  boost::container::small_vector<AllowedSide, 16> sides_;
};

}  // namespace

std::vector<HalfPlane> overlap_region(const minkowski::Obstacle& obstacle, const OverlappingPosition& position,
                                      const RegionSettings& settings) {
  Vec about = position.about;
  if (about == position.r) {
    const RealVec wanted = wanted_of(settings);
    const auto [x, y] = obstacle.direction_to_frame(wanted.x, wanted.y);
    const auto outside = nearest_outside(obstacle.sum(), obstacle.to_frame(position.r), position.allowance, {x, y});
    if (outside) about = obstacle.from_frame(*outside);
  }
  RegionSettings greedy = settings;
  greedy.rule = RegionRule::kGreedy;
  std::vector<HalfPlane> planes = free_region(obstacle, about, greedy);
  Chords{planes, position, settings.reach}.add();
  return planes;
}

}  // namespace selvage::model
