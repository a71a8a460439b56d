#include "core/motion/surroundings.h"

#include <algorithm>
#include <cmath>

#include "core/minkowski/edges_near.h"
#include "core/minkowski/nearest_edges.h"

namespace selvage {
namespace {

// Which side of the sum's border the point is on, by the edges that a ray from it crosses.
bool inside(const MinkowskiSum& sum, Vec point) {
  const Box& all = sum.box();
  if (point.x <= all.low.x || point.x >= all.high.x || point.y <= all.low.y || point.y >= all.high.y) return false;
  bool odd = false;
  for_each_edge_near(sum, {point, {all.high.x, point.y}}, [&](const SumEdge& edge) {
    if ((edge.from.y <= point.y) == (edge.to.y <= point.y)) return;
    const bool upwards = edge.to.y > edge.from.y;
    if (side_of(edge.from, edge.to, point) == (upwards ? 1 : -1)) odd = !odd;
  });
  return odd;
}

// An edge where the obstacle lies.
struct PlacedEdge {
  Vec from, to, line_from, line_to;
};
PlacedEdge placed(const SumEdge& edge, const Obstacle& obstacle, Vec at) {
  PlacedEdge e{obstacle.from_frame(edge.from) + at, obstacle.from_frame(edge.to) + at,
               obstacle.from_frame(edge.line_from) + at, obstacle.from_frame(edge.line_to) + at};
  if (obstacle.flips()) {
    std::swap(e.from, e.to);
    std::swap(e.line_from, e.line_to);
  }
  return e;
}

}  // namespace

Surroundings::Surroundings(const Scene& scene, std::uint32_t piece, const Box& window, Vec origin)
    : scene_{scene}, piece_{piece}, origin_{origin}, spacing_{scene.marker.spacing} {
  const Box own = scene.pieces[piece].box;
  const Box swept = Box{window.low + own.low, window.high + own.high}.grown(spacing_ + 1);
  for (std::uint32_t other = 0; other < scene.pieces.size(); ++other) {
    if (other == piece || !swept.touches(scene.pieces.box(other))) continue;
    near_.push_back({other, scene.sums.obstacle(scene.outlines[other], scene.outlines[piece])});
    first_line_.push_back(static_cast<std::uint32_t>(lines_.size()));
    append_lines(near_.back(), window);
  }
  first_line_.push_back(static_cast<std::uint32_t>(lines_.size()));
}

void Surroundings::append_lines(const Near& near, const Box& window) {
  const Vec at = scene_.pieces.at(near.piece);
  const Vec a = near.obstacle.to_frame(window.low - at);
  const Vec b = near.obstacle.to_frame(window.high - at);
  const Box in_frame = Box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  const auto index = static_cast<std::uint32_t>(near_.size() - 1);
  const auto moved = static_cast<double>(spacing_);
  std::optional<Vec> last_end;
  for_each_edge_near(near.obstacle.sum(), in_frame.grown(spacing_ + 2), [&](const SumEdge& edge) {
    const PlacedEdge e = placed(edge, near.obstacle, at);
    BorderLine line{real(e.from), real(e.to), 0, index, e.line_from - origin_, e.line_to - e.line_from};
    if (spacing_ > 0) {
      const Real2 out = outwards(line, line.a);
      const auto shifted = [&](Real2 p) { return Real2{p.x + moved * out.x, p.y + moved * out.y}; };
      for (const Vec corner : {e.from, e.to}) {
        if (corner != last_end) lines_.push_back({real(corner), real(corner), moved, index, {}, {}});
        last_end = corner;
      }
      line = {shifted(line.a), shifted(line.b), 0, index, {}, {}};
    }
    lines_.push_back(line);
  });
}

bool Surroundings::forbids(std::size_t obstacle, Real2 point) const {
  const Near& near = near_[obstacle];
  const Vec position{origin_.x + std::llround(point.x), origin_.y + std::llround(point.y)};
  const Vec r = near.obstacle.to_frame(position - scene_.pieces.at(near.piece));
  if (inside(near.obstacle.sum(), r)) return true;
  if (spacing_ == 0) return false;
  NearestEdges edges{near.obstacle.sum(), r, static_cast<double>(spacing_)};
  return edges.next([](const Box&) { return false; }).has_value();
}

bool Surroundings::free(Vec position) const {
  PlacedPolygon moved = scene_.pieces[piece_];
  moved.at = position;
  const Box box = moved.placed_box().grown(spacing_);
  return std::none_of(near_.begin(), near_.end(), [&](const Near& near) {
    const PlacedPolygon still = scene_.pieces[near.piece];
    if (!box.overlaps(still.placed_box())) return false;
    return spacing_ > 0 ? closer_than(moved, still, spacing_) : overlap(moved, still);
  });
}

}  // namespace selvage
