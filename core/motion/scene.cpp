#include "core/motion/scene.h"

#include "core/marker/validity.h"
#include "core/model/position_model.h"

namespace selvage {

Scene::Scene(const Marker& start, SumCache& sum_cache) : marker{start}, sums{sum_cache}, pieces{start} {
  outlines.reserve(start.pieces.size());
  group.reserve(start.pieces.size());
  for (std::uint32_t i = 0; i < start.pieces.size(); ++i) {
    outlines.push_back(oriented_outline(start, PieceId{i}, sums));
    group.push_back(start.pieces[i].locked ? PositionModel::kFixed : i);
  }
}

bool Scene::fixed(std::size_t piece) const {
  return group[piece] == PositionModel::kFixed;
}

Marker Scene::result() const {
  Marker moved = marker;
  for (std::size_t i = 0; i < moved.pieces.size(); ++i) moved.pieces[i].at = pieces.at(i);
  return moved;
}

}  // namespace selvage
