#include "bench/sums/outline_pairs.h"

#include <set>
#include <tuple>

#include "core/marker/placed_pieces.h"
#include "core/marker/validity.h"
#include "core/minkowski/cache.h"
#include "core/motion/compaction/compact.h"
#include "tests/support/polygons.h"

namespace selvage::bench {

std::vector<OutlinePair> neighbours_in(const Marker& marker) {
  SumCache sums;
  const marker::PlacedPieces pieces{marker};
  const double trust = compaction_settings(motion::compaction::Accuracy::kStandard).trust;
  const auto distance = static_cast<Coord>(trust * static_cast<double>(marker.strip.width));
  std::set<std::tuple<Polygon, Polygon, Symmetry>> seen;
  std::vector<OutlinePair> pairs;
  for (const auto& [first, second] : pairs_within(pieces, distance)) {
    const outline::OrientedOutline p = oriented_outline(marker, PieceId{first}, sums);
    const outline::OrientedOutline q = oriented_outline(marker, PieceId{second}, sums);
    const Symmetry relative = p.symmetry.inverse().after(q.symmetry);
    if (seen.emplace(p.outline->polygon, q.outline->polygon, relative).second) {
      pairs.push_back({p.outline, q.outline, relative});
    }
  }
  return pairs;
}

std::vector<OutlinePair> random_stars(std::size_t vertices, std::size_t pairs) {
  test::Random random{vertices};
  const auto star = [&] {
    for (;;) {
      auto outline = outline::make_outline(test::random_star(random, vertices, Coord{1} << 30));
      if (outline->parts.size() == 1) return outline;
    }
  };
  std::vector<OutlinePair> stars;
  while (stars.size() < pairs) {
    const auto p = star();
    stars.push_back({p, star(), {}});
  }
  return stars;
}

}  // namespace selvage::bench
