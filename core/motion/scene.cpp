#include "core/motion/scene.h"

namespace selvage {
Scene::Scene(const Marker& start, SumCache& sum_cache)
    : marker{start}, sums{sum_cache}, pieces{start}, outlines{outlines_of(start, sum_cache)}, ties{ties_of(start)} {}

Scene::Scene(const Marker& start, const LaidOut& laid_out, SumCache& sum_cache)
    : marker{start}, sums{sum_cache}, pieces{laid_out.pieces}, outlines{laid_out.outlines}, ties{laid_out.ties} {}

void Scene::shift(std::size_t piece, Vec by) {
  std::vector<Vec> positions = pieces.positions();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (ties.x[i] != Ties::kFixed && ties.x[i] == ties.x[piece]) positions[i].x += by.x;
    if (ties.y[i] != Ties::kFixed && ties.y[i] == ties.y[piece]) positions[i].y += by.y;
  }
  pieces.place(std::move(positions));
}

std::vector<Obstacle> Scene::obstacles(std::span<const PiecePair> pairs, const Crew& crew) const {
  std::vector<OutlinePair> asked;
  asked.reserve(pairs.size());
  for (const auto& [p, q] : pairs) asked.emplace_back(&outlines[p], &outlines[q]);
  return sums.obstacles(asked, crew);
}

Marker Scene::result() const {
  Marker moved = marker;
  for (std::size_t i = 0; i < moved.pieces.size(); ++i) moved.pieces[i].at = pieces.at(i);
  return moved;
}

}  // namespace selvage
