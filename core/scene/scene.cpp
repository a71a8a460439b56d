#include "core/scene/scene.h"

#include <utility>

#include "core/marker/validity.h"

namespace selvage::scene {

namespace {

Marker with_positions(Marker marker, const marker::PlacedPieces& pieces) {
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) marker.pieces[i].at = pieces.at(i);
  return marker;
}

}  // namespace

Scene::Scene(Marker start, SumCache& sum_cache) : Scene{std::move(start), Run{sum_cache}} {}

Scene::Scene(Marker start, const Run& run)
    : marker{std::move(start)},
      sums{run.sums},
      pieces{marker},
      outlines{outlines_of(marker, run)},
      parts{parts_of(marker, run.sums)},
      ties{model::ties_of(marker)} {}

Scene::Scene(Marker start, const LaidOut& laid_out, SumCache& sum_cache)
    : marker{std::move(start)},
      sums{sum_cache},
      pieces{laid_out.pieces},
      outlines{laid_out.outlines},
      parts{laid_out.parts},
      ties{laid_out.ties} {}

void Scene::shift(PieceId piece, Vec by) {
  std::vector<Vec> positions = pieces.positions();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (ties.x[i] != model::Ties::kFixed && ties.x[i] == ties.x[piece.value]) positions[i].x += by.x;
    if (ties.y[i] != model::Ties::kFixed && ties.y[i] == ties.y[piece.value]) positions[i].y += by.y;
  }
  pieces.place(std::move(positions));
}

void Scene::reorient(PieceId piece, const Orientation& orientation, Vec at) {
  Piece& own = marker.pieces[piece.value];
  own.orientation = orientation;
  own.at = at;
  outlines[piece.value] = oriented_outline(marker, piece, sums);
  if (own.rules.part) parts[piece.value] = marker::oriented_part(own, sums);
  pieces.replace(piece.value, oriented(marker.shapes[own.shape.value].outline, orientation), at, turned_match(own),
                 turned_part(own));
}

std::vector<minkowski::Obstacle> Scene::obstacles(std::span<const marker::PiecePair> pairs, const Executor& executor,
                                                  const std::stop_token& stop) const {
  std::vector<minkowski::OutlinePair> asked;
  asked.reserve(pairs.size());
  for (const auto& [p, q] : pairs) asked.emplace_back(&outline_facing(p, q), &outline_facing(q, p));
  return sums.obstacles(asked, executor, stop);
}

Marker Scene::result() const& {
  return with_positions(marker, pieces);
}

Marker Scene::result() && {
  return with_positions(std::move(marker), pieces);
}

}  // namespace selvage::scene
