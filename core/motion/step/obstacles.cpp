#include "core/motion/step/obstacles.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace selvage::motion::step {

Obstacles::Obstacles(const scene::Scene& scene, double simplification)
    : scene_{scene}, tolerance_{std::llround(simplification * static_cast<double>(scene.marker.strip.width))} {
  if (tolerance_ == 0) return;
  std::map<std::pair<const outline::Outline*, int>, std::size_t> known;
  for (const outline::OrientedOutline& own : scene.outlines) {
    const auto [at, fresh] = known.try_emplace({own.outline.get(), own.symmetry.index()}, grown_.size());
    if (fresh) {
      const outline::OrientedOutline outline{scene.sums.grown(own.outline, tolerance_), own.symmetry};
      Polygon polygon = transformed(outline.outline->polygon, own.symmetry);
      const Box box = box_of(polygon);
      grown_.push_back({outline, std::move(polygon), box});
    }
    grown_of_.push_back(at->second);
  }
}

geometry::PlacedPolygon Obstacles::placed(std::uint32_t piece) const {
  const Grown& grown = grown_[grown_of_[piece]];
  return {grown.polygon, grown.box, scene_.pieces.at(piece)};
}

minkowski::OutlinePair Obstacles::outlines(marker::PiecePair pair) const {
  const auto [p, q] = pair;
  const bool by_part = scene_.pieces.shows_part(p, q) || scene_.pieces.shows_part(q, p);
  const bool own = tolerance_ == 0 || by_part ||
                   closer_than(placed(p), placed(q), std::max(scene_.pieces.spacing(pair), Coord{0}) + tolerance_);
  if (own) return {&scene_.outline_facing(p, q), &scene_.outline_facing(q, p)};
  return {&grown_[grown_of_[p]].outline, &grown_[grown_of_[q]].outline};
}

minkowski::Obstacle Obstacles::of(marker::PiecePair pair) const {
  const auto [p, q] = outlines(pair);
  return scene_.sums.obstacle(*p, *q);
}

std::vector<minkowski::Obstacle> Obstacles::of(std::span<const marker::PiecePair> pairs, const Executor& executor,
                                               const std::stop_token& stop) const {
  std::vector<minkowski::OutlinePair> all;
  all.reserve(pairs.size());
  for (const marker::PiecePair& pair : pairs) all.push_back(outlines(pair));
  return scene_.sums.obstacles(all, executor, stop);
}

}  // namespace selvage::motion::step
