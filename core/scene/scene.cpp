#include "core/scene/scene.h"

namespace selvage::scene {
Scene::Scene(const Marker& start, SumCache& sum_cache)
    : marker{start},
      sums{sum_cache},
      pieces{start},
      outlines{outlines_of(start, sum_cache)},
      ties{model::ties_of(start)} {}

Scene::Scene(const Marker& start, const LaidOut& laid_out, SumCache& sum_cache)
    : marker{start}, sums{sum_cache}, pieces{laid_out.pieces}, outlines{laid_out.outlines}, ties{laid_out.ties} {}

void Scene::shift(std::size_t piece, Vec by) {
  std::vector<Vec> positions = pieces.positions();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (ties.x[i] != model::Ties::kFixed && ties.x[i] == ties.x[piece]) positions[i].x += by.x;
    if (ties.y[i] != model::Ties::kFixed && ties.y[i] == ties.y[piece]) positions[i].y += by.y;
  }
  pieces.place(std::move(positions));
}

std::vector<minkowski::Obstacle> Scene::obstacles(std::span<const marker::PiecePair> pairs,
                                                  const Executor& executor) const {
  std::vector<minkowski::OutlinePair> asked;
  asked.reserve(pairs.size());
  for (const auto& [p, q] : pairs) asked.emplace_back(&outlines[p], &outlines[q]);
  return sums.obstacles(asked, executor);
}

Marker Scene::result() const {
  Marker moved = marker;
  for (std::size_t i = 0; i < moved.pieces.size(); ++i) moved.pieces[i].at = pieces.at(i);
  return moved;
}

}  // namespace selvage::scene
