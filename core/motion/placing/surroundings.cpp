#include "core/motion/placing/surroundings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/marker/clearance.h"
#include "core/minkowski/edges_near.h"
#include "core/minkowski/inner_fit.h"
#include "core/minkowski/nearest_edges.h"

namespace selvage::motion::placing {
namespace {

// True when the point is inside the sum, by counting the edges that a ray from it crosses.
bool inside(const minkowski::MinkowskiSum& sum, Vec point) {
  const Box& all = sum.box();
  if (point.x <= all.low.x || point.x >= all.high.x || point.y <= all.low.y || point.y >= all.high.y) return false;
  bool odd = false;
  for_each_edge_near(sum, {point, {all.high.x, point.y}}, [&](const minkowski::convolution::SumEdge& edge) {
    if ((edge.from.y <= point.y) == (edge.to.y <= point.y)) return;
    const bool upwards = edge.to.y > edge.from.y;
    if (side_of(edge.from, edge.to, point) == (upwards ? 1 : -1)) odd = !odd;
  });
  return odd;
}

// An edge, placed where the obstacle lies.
struct PlacedEdge {
  Vec from, to, line_from, line_to;
};
PlacedEdge placed(const minkowski::convolution::SumEdge& edge, const minkowski::Obstacle& obstacle, Vec at) {
  PlacedEdge e{obstacle.from_frame(edge.from) + at, obstacle.from_frame(edge.to) + at,
               obstacle.from_frame(edge.line_from) + at, obstacle.from_frame(edge.line_to) + at};
  if (obstacle.flips()) {
    std::swap(e.from, e.to);
    std::swap(e.line_from, e.line_to);
  }
  return e;
}

}  // namespace

Body::Body(const scene::Scene& scene, PieceId id)
    : moving(scene.pieces.size()),
      at{scene.pieces.at(id.value)},
      fixed_x{scene.ties.x[id.value] == model::Ties::kFixed},
      fixed_y{scene.ties.y[id.value] == model::Ties::kFixed} {
  for (std::uint32_t i = 0; i < scene.pieces.size(); ++i) {
    moving[i] = i == id.value || scene.ties.joined(i, id.value);
    if (moving[i]) members.push_back({i, scene.pieces.at(i) - at});
  }
}

Box Body::fit(const scene::Scene& scene, Coord end) const {
  Box all{{-kLatticeLimit, -kLatticeLimit}, {kLatticeLimit, kLatticeLimit}};
  for (const Member& member : members) {
    const Box room = scene.pieces.room_among(member.piece, moving, scene.marker.strip, end);
    const Box one = minkowski::inner_fit(scene.pieces[member.piece].box, room).moved(-member.offset);
    all.low = {std::max(all.low.x, one.low.x), std::max(all.low.y, one.low.y)};
    all.high = {std::min(all.high.x, one.high.x), std::min(all.high.y, one.high.y)};
  }
  if (fixed_x) all.low.x = all.high.x = at.x;
  if (fixed_y) all.low.y = all.high.y = at.y;
  return all;
}

Surroundings::Surroundings(const scene::Scene& scene, const Body& body, const Box& window, Vec origin,
                           const std::stop_token& stop)
    : scene_{scene}, origin_{origin} {
  for (const Body::Member& member : body.members) append_near(body, member, window, stop);
  first_line_.push_back(static_cast<std::uint32_t>(lines_.size()));
}

void Surroundings::append_near(const Body& body, const Body::Member& member, const Box& window,
                               const std::stop_token& stop) {
  complete_ = complete_ && !stop.stop_requested();
  if (!complete_) return;
  const Box own = scene_.pieces[member.piece].box.moved(member.offset);
  const Box swept = Box{window.low + own.low, window.high + own.high}.grown(scene_.pieces.widest_spacing() + 1);
  for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
    if (!swept.touches(scene_.pieces.box(other)) || body.holds(other)) continue;
    if (scene_.pieces.may_share_cloth(member.piece, other)) continue;
    auto obstacle = scene_.obstacle({other, member.piece}, stop);
    complete_ = obstacle.has_value();
    if (!complete_) return;
    near_.push_back(
        {member.piece, other, member.offset, scene_.pieces.spacing({member.piece, other}), *std::move(obstacle)});
    first_line_.push_back(static_cast<std::uint32_t>(lines_.size()));
    append_lines(near_.back(), window);
  }
}

void Surroundings::append_lines(const Near& near, const Box& window) {
  const Vec at = scene_.pieces.at(near.other) - near.offset;
  const Vec a = near.obstacle.to_frame(window.low - at);
  const Vec b = near.obstacle.to_frame(window.high - at);
  const Box in_frame = Box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  const auto index = static_cast<std::uint32_t>(near_.size() - 1);
  const auto moved = static_cast<double>(near.spacing);
  std::optional<Vec> last_end;
  const Box window_in_frame = in_frame.grown(std::abs(near.spacing) + 2);
  for_each_edge_near(near.obstacle.sum(), window_in_frame, [&](const minkowski::convolution::SumEdge& edge) {
    const PlacedEdge e = placed(edge, near.obstacle, at);
    const BorderLine line{real(e.from), real(e.to), 0, index, e.line_from - origin_, e.line_to - e.line_from};
    if (near.spacing == 0) {
      lines_.push_back(line);
      return;
    }
    const RealVec out = outwards(line, line.a);
    const auto shifted = [&](RealVec p) { return RealVec{p.x + moved * out.x, p.y + moved * out.y}; };
    for (const Vec corner : {e.from, e.to}) {
      if (corner != last_end) {
        lines_.push_back({real(corner), real(corner), std::abs(moved), index, {}, {}, near.spacing < 0});
      }
      last_end = corner;
    }
    lines_.push_back({shifted(line.a), shifted(line.b), 0, index, {}, {}});
  });
}

bool Surroundings::forbids(std::size_t obstacle, RealVec point) const {
  const Near& near = near_[obstacle];
  const Vec position{origin_.x + std::llround(point.x), origin_.y + std::llround(point.y)};
  const Vec r = near.obstacle.to_frame(position + near.offset - scene_.pieces.at(near.other));
  const auto near_boundary = [&](Coord distance) {
    minkowski::NearestEdges edges{near.obstacle.sum(), r, static_cast<double>(distance)};
    return edges.next([](const Box&) { return false; }).has_value();
  };
  if (inside(near.obstacle.sum(), r)) return near.spacing >= 0 || !near_boundary(-near.spacing);
  return near.spacing > 0 && near_boundary(near.spacing);
}

bool Surroundings::free(Vec position) const {
  return std::none_of(near_.begin(), near_.end(), [&](const Near& near) {
    geometry::PlacedPolygon moved = scene_.pieces.facing(near.member, near.other);
    moved.at = position + near.offset;
    const geometry::PlacedPolygon still = scene_.pieces.facing(near.other, near.member);
    return moved.placed_box().grown(near.spacing).overlaps(still.placed_box()) &&
           marker::collide(moved, still, near.spacing);
  });
}

}  // namespace selvage::motion::placing
