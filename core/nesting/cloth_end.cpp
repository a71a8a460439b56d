#include "core/nesting/cloth_end.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/motion/placing/place.h"
#include "core/nesting/filling/lying.h"
#include "core/scene/scene.h"

namespace selvage::nesting {
namespace {

// Work on putting pieces back, counted in pieces that each trial of an orientation looks at.
constexpr std::size_t kMostLookedAt = 20'000'000;

// Computes the sums of the last piece with all others before it is placed, because only this looks at the time between
// two of them.  False when it was stopped.
bool has_sums(const scene::Scene& scene, const scene::Run& run) {
  std::vector<marker::PiecePair> pairs;
  const auto last = static_cast<std::uint32_t>(scene.pieces.size() - 1);
  for (std::uint32_t other = 0; other < last; ++other) pairs.emplace_back(other, last);
  return scene.obstacles(pairs, *run.executor, run.stop).size() == pairs.size();
}

// The piece at a free position on the cloth, as far left as the orientations allow; nothing when there is none, and
// when time is up.
std::optional<Piece> put_down(const Marker& lying, Piece piece, const layout::Kind& kind, const scene::Run& run) {
  const Piece original = piece;
  piece.locked = {};
  piece.group.clear();
  std::optional<Piece> best;
  for (const layout::Turned& turned : kind.turned) {
    piece.orientation = turned.orientation;
    Marker with_piece = lying;
    with_piece.pieces.push_back(piece);
    const scene::Scene scene{std::move(with_piece), run.sums};
    const PieceId id{static_cast<std::uint32_t>(lying.pieces.size())};
    if (!has_sums(scene, run)) return std::nullopt;
    const auto place = motion::placing::place(scene, id, {0, lying.strip.width / 2}, {.tuning = {}, .stop = run.stop});
    if (!place || (best && best->at.x <= place->at.x)) continue;
    best = original;
    best->orientation = turned.orientation;
    best->at = place->at;
  }
  return best;
}

// Puts pieces that do not lie where there is room for them, the largest first, until time or work is used up.
void put_back(filling::Filling& filling, const layout::PieceSet& set, const Budget& budget, const scene::Run& run) {
  std::vector<std::size_t> off;
  for (std::size_t i = 0; i < filling.lies.size(); ++i) {
    if (!filling.lies[i]) off.push_back(i);
  }
  std::stable_sort(off.begin(), off.end(),
                   [&set](std::size_t a, std::size_t b) { return set.kind(a).area > set.kind(b).area; });
  std::set<std::uint32_t> hopeless;  // kinds: once one of them does not fit, none does
  std::size_t looked_at = 0;
  for (const std::size_t i : off) {
    if (budget.out_of_time() || looked_at > kMostLookedAt) break;
    if (hopeless.contains(set.kind_of[i])) continue;
    looked_at += set.kind(i).turned.size() * set.size();
    Marker lying = filling::with_lying_pieces(filling.marker, filling.lies);
    lying.unplaced.clear();
    if (auto placed = put_down(lying, filling.marker.pieces[i], set.kind(i), run)) {
      filling.marker.pieces[i] = *std::move(placed);
      filling.lies[i] = true;
    } else {
      hopeless.insert(set.kind_of[i]);
    }
  }
}

}  // namespace

filling::Filling end_with_cloth(Marker all, const AtClothEnd& at, const scene::Run& run) {
  filling::Filling filling{.marker = std::move(all)};
  const auto last = filling.marker.strip.last();
  filling.lies.assign(filling.marker.pieces.size(), true);
  if (last) {
    filling.lies = filling::pieces_before(filling.marker, *last);
    put_back(filling, at.set, at.budget, run);
  }
  filling.value = filling::value_of(filling.lies, at.values);
  const bool all_lie = std::find(filling.lies.begin(), filling.lies.end(), false) == filling.lies.end();
  if (all_lie || at.set.size() > at.tuning.most_pieces) return filling;
  const filling::FillSettings settings{.values = at.values,
                                       .seed = at.seed,
                                       .map_bytes = at.tuning.map_bytes,
                                       .over = [&at](std::uint64_t moves) { return at.budget.over(at.moves + moves); },
                                       .search = at.tuning.search,
                                       .tuning = at.tuning.fill};
  return fill(std::move(filling), at.set, settings, run);
}

}  // namespace selvage::nesting
