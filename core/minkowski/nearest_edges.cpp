#include "core/minkowski/nearest_edges.h"

#include <algorithm>

namespace selvage::minkowski {
namespace {

// The parameter, along the segment that starts at (ax, ay) with direction (dx, dy), of its point nearest to the origin.
double nearest_parameter(double ax, double ay, double dx, double dy) {
  return std::clamp(-(ax * dx + ay * dy) / (dx * dx + dy * dy), 0.0, 1.0);
}

}  // namespace

NearestEdges::NearestEdges(const MinkowskiSum& sum, Vec from, double reach)
    : sum_{sum}, from_{from}, squared_reach_{reach * reach} {
  if (!sum.edges().empty()) push(static_cast<std::uint32_t>(sum.tree().levels()), 0);
}

void NearestEdges::push(std::uint32_t level, std::size_t index) {
  const double d = level == 0 ? squared_distance(sum_.edges()[index]) : squared_distance(sum_.tree().box(level, index));
  if (d > squared_reach_) return;
  heap_.push_back({d, level, static_cast<std::uint32_t>(index)});
  std::push_heap(heap_.begin(), heap_.end(), farther);
}

double NearestEdges::squared_distance(const Box& box) const {
  const auto dx = static_cast<double>(std::max({box.low.x - from_.x, from_.x - box.high.x, Coord{0}}));
  const auto dy = static_cast<double>(std::max({box.low.y - from_.y, from_.y - box.high.y, Coord{0}}));
  return dx * dx + dy * dy;
}

double NearestEdges::squared_distance(const convolution::SumEdge& edge) const {
  const auto ax = static_cast<double>(edge.from.x - from_.x);
  const auto ay = static_cast<double>(edge.from.y - from_.y);
  const auto dx = static_cast<double>(edge.to.x - edge.from.x);
  const auto dy = static_cast<double>(edge.to.y - edge.from.y);
  const double t = nearest_parameter(ax, ay, dx, dy);
  const double x = ax + t * dx;
  const double y = ay + t * dy;
  return x * x + y * y;
}

BoundaryPoint nearest_boundary_point(const MinkowskiSum& sum, Vec from) {
  NearestEdges edges{sum, from, std::numeric_limits<double>::infinity()};
  const auto nearest = edges.next([](const Box&) { return false; });
  if (!nearest) return {{}, std::numeric_limits<double>::infinity(), nullptr};  // no edge is longer than rounding
  const convolution::SumEdge& e = *nearest->edge;
  const auto dx = static_cast<double>(e.to.x - e.from.x);
  const auto dy = static_cast<double>(e.to.y - e.from.y);
  const double t =
      nearest_parameter(static_cast<double>(e.from.x - from.x), static_cast<double>(e.from.y - from.y), dx, dy);
  return {{static_cast<double>(e.from.x) + t * dx, static_cast<double>(e.from.y) + t * dy},
          std::sqrt(nearest->squared_distance),
          &e};
}

}  // namespace selvage::minkowski
