#include "core/motion/separation/leap.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/minkowski/inner_fit.h"
#include "core/minkowski/nearest_edges.h"

namespace selvage::motion::separation {
namespace {

// Another piece within reach.
struct Neighbour {
  marker::PiecePair pair;
  minkowski::Obstacle obstacle;
  Vec at;
  double price{};
};

std::vector<Neighbour> neighbours_of(const scene::Scene& scene, std::uint32_t piece, double reach,
                                     const OverlapPrices& prices) {
  const Box box = scene.pieces.box(piece).grown(std::llround(reach) + scene.pieces.widest_spacing());
  std::vector<Neighbour> found;
  for (std::uint32_t other = 0; other < scene.pieces.size(); ++other) {
    if (other == piece || scene.pieces.may_share_cloth(piece, other)) continue;
    if (!box.overlaps(scene.pieces.box(other))) continue;
    const marker::PiecePair pair = std::minmax(piece, other);
    found.push_back({pair, scene.obstacle(pair), scene.pieces.at(other), prices.of(pair)});
  }
  return found;
}

// Where the piece may leap to, on any repeat of the cloth's pattern.
Box room_of(const scene::Scene& scene, std::uint32_t piece, Coord end) {
  const marker::Rules& rules = scene.marker.pieces[piece].rules;
  const Strip& strip = scene.marker.strip;
  const geometry::PlacedPolygon polygon = scene.pieces[piece];
  return room_for(rules, polygon.box.height(), fold_edge(rules, polygon.vertices, strip), strip, end);
}

// The positions of the grid on one axis, from that at `at`.  Where a pattern repeats they are whole repeats away, and
// only those between low and high count; elsewhere they stop there.
std::vector<Coord> positions_on(Coord at, Coord low, Coord high, Coord repeat, const LeapGrid& grid) {
  const double step = grid.reach / grid.steps;
  const Coord repeats =
      repeat == 0 ? 0 : std::max(Coord{1}, static_cast<Coord>(std::llround(step / static_cast<double>(repeat))));
  std::vector<Coord> positions;
  for (int k = -grid.steps; k <= grid.steps; ++k) {
    if (repeat == 0) {
      const Coord to = at + static_cast<Coord>(std::llround(grid.reach * k / grid.steps));
      positions.push_back(std::clamp(to, low, std::max(low, high)));
    } else if (const Coord to = at + k * repeats * repeat; k == 0 || (to >= low && to <= high)) {
      positions.push_back(to);
    }
  }
  return positions;
}

// The distance by which the pieces would have to move apart.
double depth_at(const minkowski::Obstacle& obstacle, Vec r, Coord spacing) {
  const Vec at = obstacle.to_frame(r);
  if (!obstacle.sum().box().grown(spacing).touches({at, at})) return 0;
  const bool inside = obstacle.sum().contains({static_cast<double>(at.x), static_cast<double>(at.y)});
  if (!inside && spacing <= 0) return 0;
  const double distance = nearest_boundary_point(obstacle.sum(), at).distance;
  return std::max(0.0, static_cast<double>(spacing) + (inside ? distance : -distance));
}

}  // namespace

Leap cheapest_leap(const scene::Scene& scene, PieceId id, const LeapGrid& grid, const OverlapPrices& prices) {
  const std::uint32_t piece = id.value;
  const Vec from = scene.pieces.at(piece);
  const Box fit = minkowski::inner_fit(scene.pieces[piece].box, room_of(scene, piece, grid.length));
  Leap best{from, std::numeric_limits<double>::infinity()};
  const Vec repeat = scene.pieces.repeat_of(piece, scene.marker.strip);
  const std::vector<Coord> columns = positions_on(from.x, fit.low.x, fit.high.x, repeat.x, grid);
  const std::vector<Coord> rows = positions_on(from.y, fit.low.y, fit.high.y, repeat.y, grid);
  const Coord farthest = std::max(
      {from.x - columns.front(), columns.back() - from.x, from.y - rows.front(), rows.back() - from.y, Coord{0}});
  const double reach = std::max(grid.reach, static_cast<double>(farthest));
  const std::vector<Neighbour> neighbours = neighbours_of(scene, piece, reach, prices);
  for (const Coord y : rows) {
    for (const Coord x : columns) {
      const Vec to{x, y};
      double cost = static_cast<double>(std::abs(to.x - from.x) + std::abs(to.y - from.y));
      for (const Neighbour& neighbour : neighbours) {
        if (cost >= best.cost) break;
        const Vec r = neighbour.pair.first == piece ? neighbour.at - to : to - neighbour.at;
        cost += neighbour.price * depth_at(neighbour.obstacle, r, scene.pieces.spacing(neighbour.pair));
      }
      if (cost < best.cost) best = {to, cost};
    }
  }
  return best;
}

}  // namespace selvage::motion::separation
