#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/packing/coverings/covering.h"

namespace selvage::packing::coverings {
namespace {

// Slices are cut one unit beyond the rounded corners, so those between corners nearer than this are covered by their
// neighbours; lattice units.
constexpr double kThinnest = 2 * cells::kRaySlack;

HalfPlane right_of(double x) {
  return {1, 0, x - cells::kRaySlack};
}

HalfPlane left_of(double x) {
  return {-1, 0, -x - cells::kRaySlack};
}

// The edges that cross the vertical line at x, from below.
std::vector<std::uint32_t> crossed_at(const WedgeRing& ring, double x) {
  std::vector<std::pair<double, std::uint32_t>> crossed;
  for (std::uint32_t k = 0; k < ring.size(); ++k) {
    const RealVec a = ring.corner(k);
    const RealVec b = ring.corner((k + 1) % ring.size());
    if ((a.x < x) == (b.x < x)) continue;
    crossed.emplace_back(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x), k);
  }
  std::sort(crossed.begin(), crossed.end());
  std::vector<std::uint32_t> edges;
  for (const auto& [y, edge] : crossed) edges.push_back(edge);
  return edges;
}

// The edges below and above a slice; none where it is not bounded.
using Bounds = std::pair<std::optional<std::uint32_t>, std::optional<std::uint32_t>>;

// The parts of the outside on a vertical line that crosses these edges.
std::vector<Bounds> outside_between(const std::vector<std::uint32_t>& crossed) {
  std::vector<Bounds> parts;
  std::optional<std::uint32_t> below;
  for (std::size_t k = 0; k + 1 < crossed.size(); k += 2) {
    parts.emplace_back(below, crossed[k]);
    below = crossed[k + 1];
  }
  parts.emplace_back(below, std::nullopt);
  return parts;
}

ConvexSet slice(const WedgeRing& ring, const Bounds& bounds, double from, double to) {
  ConvexSet set{right_of(from), left_of(to)};
  if (bounds.first) set.push_back(ring.sides(*bounds.first).front());
  if (bounds.second) set.push_back(ring.sides(*bounds.second).front());
  return set;
}

}  // namespace

std::vector<ConvexSet> slices(const WedgeRing& ring) {
  std::vector<double> cuts;
  for (std::uint32_t k = 0; k < ring.size(); ++k) cuts.push_back(ring.corner(k).x);
  std::sort(cuts.begin(), cuts.end());
  std::vector<ConvexSet> sets{{left_of(cuts.front())}, {right_of(cuts.back())}};
  std::map<Bounds, double> open;  // slices that go on while their edges do, with where they began
  double end = cuts.front();
  const auto close = [&](const std::map<Bounds, double>& still) {
    for (const auto& [bounds, from] : open) {
      if (!still.contains(bounds)) sets.push_back(slice(ring, bounds, from, end));
    }
  };
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    if (cuts[k + 1] - cuts[k] <= kThinnest) continue;
    std::map<Bounds, double> now;
    for (const Bounds& bounds : outside_between(crossed_at(ring, cuts[k] / 2 + cuts[k + 1] / 2))) {
      const auto before = open.find(bounds);
      now.emplace(bounds, before == open.end() ? cuts[k] : before->second);
    }
    close(now);
    open = std::move(now);
    end = cuts[k + 1];
  }
  close({});
  return sets;
}

}  // namespace selvage::packing::coverings
