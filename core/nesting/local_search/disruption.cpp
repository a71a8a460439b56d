#include "core/nesting/local_search/disruption.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace selvage::nesting::local_search {
namespace {

using Pieces = std::vector<std::uint32_t>;

// The pieces that may move, by falling area of their hulls.
Pieces movable(const layout::PieceSet& set) {
  Pieces pieces;
  for (std::uint32_t i = 0; i < set.size(); ++i) {
    if (!set.fixed[i]) pieces.push_back(i);
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [&set](std::uint32_t a, std::uint32_t b) { return set.kind(a).hull_area > set.kind(b).hull_area; });
  return pieces;
}

// Drops all but the large ones.
Pieces large_of(const layout::PieceSet& set, Pieces pieces, double large_part) {
  const double all = std::accumulate(pieces.begin(), pieces.end(), 0.0,
                                     [&set](double sum, std::uint32_t i) { return sum + set.kind(i).hull_area; });
  double sum = 0;
  std::size_t number = 0;
  while (number < pieces.size() && sum <= large_part * all) sum += set.kind(pieces[number++]).hull_area;
  pieces.resize(number);
  return pieces;
}

bool alike(const layout::Kind& a, const layout::Kind& b) {
  constexpr double kSameArea = 0.01;
  return std::abs(a.area - b.area) <= kSameArea * a.area;
}

}  // namespace

void swap_large_pieces(const layout::PieceSet& set, depth::DepthMaps& maps, double large_part, layout::Dice& dice,
                       layout::Layout& layout) {
  const Pieces pieces = movable(set);
  if (pieces.size() < 2) return;
  const Pieces large = large_of(set, pieces, large_part);
  const std::uint32_t first = large[dice.below(large.size())];
  Pieces partners;
  for (const std::uint32_t i : large) {
    if (!alike(set.kind(i), set.kind(first))) partners.push_back(i);
  }
  if (partners.empty()) partners = pieces;
  std::erase(partners, first);
  const std::uint32_t second = partners[dice.below(partners.size())];

  const RealBox first_box = placed_box(set, layout, first);
  const RealBox second_box = placed_box(set, layout, second);
  centre_at(set, layout, first, second_box.middle_x(), second_box.middle_y());
  centre_at(set, layout, second, first_box.middle_x(), first_box.middle_y());
  const double by_x = second_box.middle_x() - first_box.middle_x();
  const double by_y = second_box.middle_y() - first_box.middle_y();
  for (const std::uint32_t i : pieces) {
    if (i == first || i == second) continue;
    for (const std::uint32_t moved : {first, second}) {
      if (set.kind(i).hull_area >= set.kind(moved).hull_area) continue;
      const layout::Place& at = layout.places[moved];
      const layout::Place& own = layout.places[i];
      const layout::Turned& turned = set.kind(i).turned[own.turn];
      const float depth = maps.view(set.kind(moved).turned[at.turn], turned)
                              .depth(static_cast<float>(own.x - at.x), static_cast<float>(own.y - at.y));
      // Only those of which most lies under it.
      if (depth <= std::min(turned.box.width(), turned.box.height()) / 2) continue;
      const double sign = moved == first ? -1 : 1;
      const RealBox box = placed_box(set, layout, i);
      centre_at(set, layout, i, box.middle_x() + sign * by_x, box.middle_y() + sign * by_y);
      break;
    }
  }
}

}  // namespace selvage::nesting::local_search
