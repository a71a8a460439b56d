#include "core/model/free_region.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <boost/container/small_vector.hpp>

#include "core/geometry/pseudo_angle.h"
#include "core/minkowski/nearest_edges.h"

namespace selvage::model {
namespace {

// Lattice units.  The rounded end of an edge may lie this far on the wrong side of a neighbour's line.
constexpr double kRounding = 1.5;
// Lattice units.  A position that lies no deeper than this behind an edge's line counts as facing the edge.
constexpr double kFacing = 3.0;
// Lattice units.  A position this near to an edge touches it.
constexpr double kTouching = 4.0;
constexpr double kTouchingPart = 1e-3;  // of the relative position, at most: on a coarse lattice 4 units are far

HalfPlane side_along(const minkowski::convolution::SumEdge& edge) {
  return {edge.line_from, edge.line_to - edge.line_from};
}

// The half-plane that cuts an edge off: bounded by its own line or, when that passes too near for the spacing, by the
// line through its point nearest to r, perpendicular to the direction from there to r.
HalfPlane cut_before(const minkowski::convolution::SumEdge& edge, Vec r, Coord spacing) {
  const HalfPlane along = side_along(edge);
  if (spacing == 0 || slack_of(along, r) >= static_cast<double>(spacing)) return along;
  const Wide past_from = dot(r - edge.from, edge.to - edge.from);
  const Wide past_to = dot(r - edge.to, edge.to - edge.from);
  if (past_from > 0 && past_to < 0) return along;
  const Vec nearest = past_from <= 0 ? edge.from : edge.to;
  const Vec out = r - nearest;
  if (out == Vec{}) return along;  // r is that point: no direction leads from it to r
  return {nearest, {-out.y, out.x}};
}

// A half-plane about the present position as origin: inside where x * nx + y * ny + slack >= 0.
struct Side {
  double nx{}, ny{}, slack{};
  [[nodiscard]] double inside_by(double x, double y) const { return x * nx + y * ny + slack; }
};
Side side_of_plane(const HalfPlane& plane, Vec r) {
  const auto dx = static_cast<double>(plane.direction.x);
  const auto dy = static_cast<double>(plane.direction.y);
  const double length = std::sqrt(dx * dx + dy * dy);
  return {dy / length, -dx / length, slack_of(plane, r)};
}

constexpr std::size_t kMany = 16;   // few regions have more sides
constexpr std::size_t kAtOnce = 8;  // few corners have more edges that are equally near

// The region so far.
class Cell {
 public:
  explicit Cell(Vec r) : r_{r} { planes_.reserve(kMany); }

  void cut(const HalfPlane& plane) {
    planes_.push_back(plane);
    sides_.push_back(side_of_plane(plane, r_));
  }
  // True when no part of the edge lies inside by more than rounding.
  [[nodiscard]] bool excludes(const minkowski::convolution::SumEdge& edge) const {
    const auto ax = static_cast<double>(edge.from.x - r_.x);
    const auto ay = static_cast<double>(edge.from.y - r_.y);
    const auto bx = static_cast<double>(edge.to.x - r_.x);
    const auto by = static_cast<double>(edge.to.y - r_.y);
    double low = 0;
    double high = 1;
    for (const Side& side : sides_) {
      const double a = side.inside_by(ax, ay) - kRounding;
      const double b = side.inside_by(bx, by) - kRounding;
      if (a <= 0 && b <= 0) return true;
      if (a < 0) low = std::max(low, a / (a - b));
      if (b < 0) high = std::min(high, a / (a - b));
      if (low >= high) return true;
    }
    return false;
  }
  [[nodiscard]] bool excludes(const Box& box) const {
    const auto x0 = static_cast<double>(box.low.x - r_.x);
    const auto y0 = static_cast<double>(box.low.y - r_.y);
    const auto x1 = static_cast<double>(box.high.x - r_.x);
    const auto y1 = static_cast<double>(box.high.y - r_.y);
    return std::any_of(sides_.begin(), sides_.end(), [&](const Side& side) {
      return side.inside_by(side.nx > 0 ? x1 : x0, side.ny > 0 ? y1 : y0) <= kRounding;
    });
  }
  [[nodiscard]] std::vector<HalfPlane> planes() && { return std::move(planes_); }

 private:
  Vec r_;
  std::vector<HalfPlane> planes_;
  boost::container::small_vector<Side, kMany> sides_;
};

// Cuts along the nearest facing edge first.  Edges that are equally near share a corner, and either line would do
// [Li94 4.1.2].  The line that is farther away leaves more room on the other side; for a piece that is to move in some
// direction, the line that obstructs it less is better.
class GreedyRegion {
 public:
  GreedyRegion(const minkowski::MinkowskiSum& sum, Vec r, const RegionSettings& settings)
      : r_{r}, settings_{settings}, cell_{r}, edges_{sum, r, settings.reach} {}

  std::vector<HalfPlane> run() {
    const auto skip = [&](const Box& box) { return cell_.excludes(box); };
    auto next = edges_.next(skip);
    while (next) {
      const double equally_near = std::sqrt(next->squared_distance) + kRounding;
      const double touching =
          std::min(kTouching, kTouchingPart * std::hypot(static_cast<double>(r_.x), static_cast<double>(r_.y)));
      touches_ = equally_near <= static_cast<double>(settings_.spacing) + touching;
      tied_.clear();
      for (; next && next->squared_distance <= equally_near * equally_near; next = edges_.next(skip)) {
        if (slack_of(side_along(*next->edge), r_) >= -kFacing) tied_.push_back(next->edge);
      }
      cut_tied();
    }
    return std::move(cell_).planes();
  }

 private:
  void cut_tied() {
    for (;;) {
      const auto excluded = [&](const minkowski::convolution::SumEdge* edge) { return cell_.excludes(*edge); };
      tied_.erase(std::remove_if(tied_.begin(), tied_.end(), excluded), tied_.end());
      if (tied_.empty()) return;
      const auto best =
          std::max_element(tied_.begin(), tied_.end(),
                           [&](const minkowski::convolution::SumEdge* a, const minkowski::convolution::SumEdge* b) {
                             return merit(*a) < merit(*b);
                           });
      cell_.cut(cut_before(**best, r_, settings_.spacing));
      tied_.erase(best);
    }
  }
  [[nodiscard]] double merit(const minkowski::convolution::SumEdge& edge) const {
    const HalfPlane line = side_along(edge);
    const auto& [towards, closing] = std::pair{settings_.towards, settings_.closing};
    const bool directed = towards.x != 0 || towards.y != 0;
    if (!directed && !(touches_ && (closing.x != 0 || closing.y != 0))) return slack_of(line, r_);
    const RealVec wanted = directed ? towards : closing;
    const Side side = side_of_plane(line, r_);
    return side.nx * wanted.x + side.ny * wanted.y;
  }

  Vec r_;
  const RegionSettings& settings_;
  Cell cell_;
  minkowski::NearestEdges edges_;
  bool touches_{};  // the edges of tied_
  boost::container::small_vector<const minkowski::convolution::SumEdge*, kAtOnce> tied_;
};

// The thesis' walk about one star sum.
class Walk {
 public:
  Walk(const minkowski::convolution::StarSum& ring, Vec r) : ring_{ring}, r_{r} {}

  std::vector<HalfPlane> run() {
    const std::size_t start = facing_edge();
    take(start);
    go(start, true);
    go(start, false);
    return std::move(planes_);
  }

 private:
  [[nodiscard]] std::size_t size() const { return ring_.edges.size(); }

  // The edge that the ray from the centre to r passes.
  [[nodiscard]] std::size_t facing_edge() const {
    const double x = static_cast<double>(r_.x) - ring_.centre.x;
    const double y = static_cast<double>(r_.y) - ring_.centre.y;
    if (x == 0 && y == 0) return 0;
    const double angle = geometry::pseudo_angle(x, y);
    std::size_t best = 0;
    double least = geometry::kFullTurn;
    for (std::size_t k = 0; k < size(); ++k) {
      const Vec from = ring_.edges[k].from;
      const double fx = static_cast<double>(from.x) - ring_.centre.x;
      const double fy = static_cast<double>(from.y) - ring_.centre.y;
      const double behind =
          std::fmod(angle - geometry::pseudo_angle(fx, fy) + geometry::kFullTurn, geometry::kFullTurn);
      if (behind < least) {
        least = behind;
        best = k;
      }
    }
    return best;
  }
  bool take(std::size_t k) {
    const HalfPlane plane = side_along(ring_.edges[k]);
    if (slack_of(plane, r_) < -kFacing) return false;
    planes_.push_back(plane);
    return true;
  }
  // From edge `k` on, follows the current line until the boundary crosses it, then continues along the crossing edge.
  void go(std::size_t k, bool counter_clockwise) {
    HalfPlane current = side_along(ring_.edges[k]);
    const Vec start = current.direction;
    for (std::size_t step = 1; step < size(); ++step) {
      k = counter_clockwise ? (k + 1) % size() : (k + size() - 1) % size();
      const minkowski::convolution::SumEdge& edge = ring_.edges[k];
      if (slack_of(current, counter_clockwise ? edge.to : edge.from) <= kRounding) continue;
      if (!ahead(current, edge, counter_clockwise) || !take(k)) continue;
      current = side_along(edge);
      if (turned_back(start, current.direction, counter_clockwise)) return;
    }
  }
  // True when the edge crosses the line ahead in the direction of the walk.
  [[nodiscard]] bool ahead(const HalfPlane& line, const minkowski::convolution::SumEdge& edge,
                           bool counter_clockwise) const {
    const Vec to = (counter_clockwise ? edge.to : edge.from) - r_;
    const Wide along = dot(to, line.direction);
    return counter_clockwise ? along > 0 : along < 0;
  }
  static bool turned_back(Vec start, Vec now, bool counter_clockwise) {
    const Wide turn = cross(start, now);
    return counter_clockwise ? turn > 0 : turn < 0;  // turns away from the sum have the other sign
  }

  const minkowski::convolution::StarSum& ring_;
  Vec r_;
  std::vector<HalfPlane> planes_;
};

std::vector<HalfPlane> walk_region(const minkowski::MinkowskiSum& sum, Vec r) {
  std::vector<HalfPlane> planes;
  for (const minkowski::convolution::StarSum& ring : sum.rings()) {
    const auto about_ring = Walk{ring, r}.run();
    planes.insert(planes.end(), about_ring.begin(), about_ring.end());
  }
  return planes;
}

}  // namespace

double slack_of(const HalfPlane& side, Vec r) {
  const auto dx = static_cast<double>(side.direction.x);
  const auto dy = static_cast<double>(side.direction.y);
  return -static_cast<double>(cross(side.direction, r - side.anchor)) / std::sqrt(dx * dx + dy * dy);
}

std::vector<HalfPlane> free_region(const minkowski::Obstacle& obstacle, Vec r, const RegionSettings& settings) {
  const Vec at = obstacle.to_frame(r);
  std::vector<HalfPlane> planes;
  if (settings.rule == RegionRule::kWalk && settings.spacing == 0) {
    planes = walk_region(obstacle.sum(), at);
  } else {
    RegionSettings in_frame = settings;
    const auto [x, y] = obstacle.direction_to_frame(settings.towards.x, settings.towards.y);
    in_frame.towards = {x, y};
    const auto [closing_x, closing_y] = obstacle.direction_to_frame(settings.closing.x, settings.closing.y);
    in_frame.closing = {closing_x, closing_y};
    planes = GreedyRegion{obstacle.sum(), at, in_frame}.run();
  }
  for (HalfPlane& plane : planes) {
    plane.anchor = obstacle.from_frame(plane.anchor);
    plane.direction = obstacle.from_frame(plane.direction);
    if (obstacle.flips()) plane.direction = -plane.direction;
  }
  return planes;
}

}  // namespace selvage::model
