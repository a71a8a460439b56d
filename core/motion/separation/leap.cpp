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

// Where the piece may leap to: a piece of a match set to where it is in phase with the others.
Box room_of(const scene::Scene& scene, std::uint32_t piece, Coord end) {
  if (scene.pieces.match_set_of(piece) == nullptr) return scene.pieces.room(piece, scene.marker.strip, end);
  return scene.pieces.room_among(piece, std::vector<bool>(scene.pieces.size()), scene.marker.strip, end);
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
  const std::vector<Neighbour> neighbours = neighbours_of(scene, piece, grid.reach, prices);
  Leap best{from, std::numeric_limits<double>::infinity()};
  const auto step = [&](int k) { return static_cast<Coord>(std::llround(grid.reach * k / grid.steps)); };
  for (int row = -grid.steps; row <= grid.steps; ++row) {
    for (int column = -grid.steps; column <= grid.steps; ++column) {
      const Vec to{std::clamp(from.x + step(column), fit.low.x, std::max(fit.low.x, fit.high.x)),
                   std::clamp(from.y + step(row), fit.low.y, std::max(fit.low.y, fit.high.y))};
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
