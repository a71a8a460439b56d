#include "core/nesting/local_search/perturbation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace selvage::nesting::local_search {
namespace {

using Pieces = std::vector<std::uint32_t>;

Pieces movable(const layout::PieceSet& set) {
  Pieces pieces;
  for (std::uint32_t i = 0; i < set.size(); ++i) {
    if (!set.fixed[i]) pieces.push_back(i);
  }
  return pieces;
}

bool alike(const layout::Kind& a, const layout::Kind& b) {
  constexpr double kSameArea = 0.01;
  return std::abs(a.area - b.area) <= kSameArea * a.area;
}

// Those that are not like the piece.
Pieces unlike(const layout::PieceSet& set, const Pieces& pieces, std::uint32_t piece) {
  Pieces others;
  for (const std::uint32_t i : pieces) {
    if (!alike(set.kind(i), set.kind(piece))) others.push_back(i);
  }
  return others;
}

std::uint32_t any_of(const Pieces& pieces, layout::Dice& dice) {
  return pieces[dice.below(pieces.size())];
}

// The pieces whose middles are nearest to that of the given one.
Pieces nearest(const layout::PieceSet& set, const layout::Layout& layout, Pieces pieces, std::uint32_t piece) {
  constexpr std::size_t kNear = 6;
  const RealBox own = placed_box(set, layout, piece);
  std::vector<std::pair<double, std::uint32_t>> by_distance;
  for (const std::uint32_t i : pieces) {
    const RealBox box = placed_box(set, layout, i);
    by_distance.emplace_back(std::hypot(box.middle_x() - own.middle_x(), box.middle_y() - own.middle_y()), i);
  }
  std::sort(by_distance.begin(), by_distance.end());
  pieces.resize(std::min(kNear, pieces.size()));
  for (std::size_t k = 0; k < pieces.size(); ++k) pieces[k] = by_distance[k].second;
  return pieces;
}

// The two change places.  Of the given pieces, the smaller ones that then lie under one of them go where it came from.
void change_places(const layout::PieceSet& set, depth::DepthMaps& maps, const Pieces& pieces, std::uint32_t first,
                   std::uint32_t second, layout::Layout& layout) {
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

void scatter(const layout::PieceSet& set, const Pieces& pieces, layout::Dice& dice, layout::Layout& layout) {
  constexpr int kScattered = 3;
  for (int k = 0; k < kScattered; ++k) {
    const std::uint32_t piece = any_of(pieces, dice);
    const double x = dice.unit() * layout.length;
    centre_at(set, layout, piece, x, set.low + dice.unit() * (set.high - set.low));
  }
}

}  // namespace

void perturb(const layout::PieceSet& set, depth::DepthMaps& maps, layout::Dice& dice, layout::Layout& layout) {
  enum Way : std::size_t { kSwapAny, kSwapNear, kScatter, kWays };
  const Pieces pieces = movable(set);
  if (pieces.empty()) return;
  const std::size_t way = dice.below(kWays);
  if (way == kScatter) return scatter(set, pieces, dice, layout);
  const std::uint32_t first = any_of(pieces, dice);
  Pieces partners = unlike(set, pieces, first);
  if (partners.empty()) return scatter(set, pieces, dice, layout);
  if (way == kSwapNear) partners = nearest(set, layout, std::move(partners), first);
  change_places(set, maps, pieces, first, any_of(partners, dice), layout);
}

}  // namespace selvage::nesting::local_search
