#include "core/motion/repair/phase.h"

#include <algorithm>

namespace selvage::motion::repair {
namespace {

// The piece that the others of the set are brought to on an axis.
std::uint32_t anchor_of(const marker::MatchSet& set, const std::vector<std::uint32_t>& ties) {
  const auto fixed = [&ties](std::uint32_t piece) { return ties[piece] == model::Ties::kFixed; };
  const auto found = std::find_if(set.begin(), set.end(), fixed);
  return found == set.end() ? set.front() : *found;
}

}  // namespace

Coord off_phase(const scene::Scene& scene) {
  Coord most = 0;
  for (const marker::MatchSet& set : scene.pieces.match_sets()) most = std::max(most, scene.pieces.off_phase(set));
  return most;
}

void into_phase(scene::Scene& scene) {
  for (const marker::MatchSet& set : scene.pieces.match_sets()) {
    const std::uint32_t along = anchor_of(set, scene.ties.x), across = anchor_of(set, scene.ties.y);
    for (const std::uint32_t piece : set) {
      const Vec by{-scene.pieces.off_phase(piece, along).x, -scene.pieces.off_phase(piece, across).y};
      if (by != Vec{}) scene.shift(PieceId{piece}, by);
    }
  }
}

}  // namespace selvage::motion::repair
