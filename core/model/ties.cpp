#include "core/model/ties.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace selvage::model {
namespace {

void join_on(std::vector<std::uint32_t>& axis, std::size_t p, std::size_t q) {
  const std::uint32_t low = std::min(axis[p], axis[q]);
  const std::uint32_t high = std::max(axis[p], axis[q]);  // kFixed is the largest
  const std::uint32_t kept = high == Ties::kFixed ? high : low;
  const std::uint32_t gone = high == Ties::kFixed ? low : high;
  if (kept != gone) std::replace(axis.begin(), axis.end(), gone, kept);
}

}  // namespace

bool Ties::free(std::size_t piece) const {
  return x[piece] != kFixed && y[piece] != kFixed && std::count(x.begin(), x.end(), x[piece]) == 1 &&
         std::count(y.begin(), y.end(), y[piece]) == 1;
}

void Ties::join(std::size_t p, std::size_t q) {
  join_on(x, p, q);
  join_on(y, p, q);
}

Ties with_match_sets(Ties ties, const marker::PlacedPieces& pieces, const Strip& strip) {
  for (const marker::MatchSet& set : pieces.match_sets()) {
    for (const std::uint32_t piece : set) {
      if (strip.repeat.along > 0) join_on(ties.x, set.front(), piece);
      if (strip.repeat.across > 0) join_on(ties.y, set.front(), piece);
    }
  }
  return ties;
}

Ties ties_of(const Marker& marker) {
  Ties ties;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    ties.x.push_back(marker.pieces[i].locked.x ? Ties::kFixed : i);
    ties.y.push_back(marker.pieces[i].locked.y ? Ties::kFixed : i);
  }
  std::map<std::string_view, std::size_t> first_of;  // of each group
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    const std::string& group = marker.pieces[i].group;
    if (group.empty()) continue;
    const auto [first, fresh] = first_of.try_emplace(group, i);
    if (!fresh) ties.join(first->second, i);
  }
  return ties;
}

}  // namespace selvage::model
