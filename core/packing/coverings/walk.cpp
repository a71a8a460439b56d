#include <algorithm>

#include "core/packing/coverings/covering.h"

namespace selvage::packing::coverings {
namespace {

// Lattice units.  Corners are rounded, and lines are moved outwards: an edge that reaches into a set by no more than
// this only touches it.
constexpr double kTouching = 2;

RealVec start_of(const WedgeRing& ring, std::uint32_t edge) {
  return ring.corner(edge);
}

RealVec end_of(const WedgeRing& ring, std::uint32_t edge) {
  return ring.corner((edge + 1) % ring.size());
}

// Whether a part of the edge lies in the set by more than touching.
bool enters(const WedgeRing& ring, std::uint32_t edge, const ConvexSet& set) {
  const RealVec a = start_of(ring, edge);
  const RealVec b = end_of(ring, edge);
  double low = 0;
  double high = 1;
  for (const HalfPlane& side : set) {
    const double room_a = side.room(a) - kTouching;
    const double room_b = side.room(b) - kTouching;
    if (room_a <= 0 && room_b <= 0) return false;
    if (room_a < 0) low = std::max(low, room_a / (room_a - room_b));
    if (room_b < 0) high = std::min(high, room_a / (room_a - room_b));
  }
  return low < high;
}

// Whether the whole edge borders on the set.
bool appears(const WedgeRing& ring, std::uint32_t edge, const ConvexSet& set) {
  return std::ranges::all_of(set, [&](const HalfPlane& side) {
    return side.room(start_of(ring, edge)) >= -kTouching && side.room(end_of(ring, edge)) >= -kTouching;
  });
}

// Whether `to`, seen from the centre, lies less than half a turn counter-clockwise of `from`.
bool is_ahead(const WedgeRing& ring, RealVec from, RealVec to) {
  const RealVec centre = ring.centre();
  return (from.x - centre.x) * (to.y - centre.y) > (from.y - centre.y) * (to.x - centre.x);
}

// The locality heuristic [Li94 4.1.2]: a convex set that borders on the edge.  Walking along the boundary, edges behind
// the lines so far are passed over, which extends those lines; one that enters the set adds its own line.  Each walk
// ends after half a turn, where all edges lie behind the line of the first: going on, it would meet the edges of the
// other walk from their far side.
ConvexSet set_at(const WedgeRing& ring, std::uint32_t start) {
  const std::uint32_t size = ring.size();
  ConvexSet set{ring.sides(start).front()};
  const auto meet = [&](std::uint32_t edge) {
    if (enters(ring, edge, set)) set.push_back(ring.sides(edge).front());
  };
  std::uint32_t edge = (start + 1) % size;
  for (; is_ahead(ring, start_of(ring, start), start_of(ring, edge)); edge = (edge + 1) % size) meet(edge);
  edge = (start + size - 1) % size;
  for (; is_ahead(ring, end_of(ring, edge), end_of(ring, start)); edge = (edge + size - 1) % size) meet(edge);
  return set;
}

}  // namespace

std::vector<ConvexSet> walk(const WedgeRing& ring) {
  std::vector<ConvexSet> sets;
  std::vector<bool> marked(ring.size());
  for (std::uint32_t start = 0; start < ring.size(); ++start) {
    if (marked[start]) continue;
    sets.push_back(set_at(ring, start));
    for (std::uint32_t edge = start; edge < ring.size(); ++edge) {
      marked[edge] = marked[edge] || appears(ring, edge, sets.back());
    }
  }
  return sets;
}

}  // namespace selvage::packing::coverings
