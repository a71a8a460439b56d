#include "core/nesting/cloth_end.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/motion/placing/place.h"
#include "core/scene/scene.h"

namespace selvage::nesting {
namespace {

// The marker of those of its pieces that lie on the cloth; the others are unplaced when `with_rest`.
Marker divided(const Marker& marker, const std::vector<bool>& lies, bool with_rest) {
  Marker result = marker;
  result.pieces.clear();
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    if (lies[i]) {
      result.pieces.push_back(marker.pieces[i]);
    } else if (with_rest) {
      result.unplaced.push_back(marker.pieces[i]);
      result.unplaced.back().at = {};
    }
  }
  return result;
}

// The piece at a free position on the cloth, as far left as the orientations allow; nothing when there is none.
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
    const auto place = motion::placing::place(scene, id, {0, lying.strip.width / 2});
    if (!place || (best && best->at.x <= place->at.x)) continue;
    best = original;
    best->orientation = turned.orientation;
    best->at = place->at;
  }
  return best;
}

}  // namespace

std::size_t end_with_cloth(Marker& marker, const layout::PieceSet& set, const scene::Run& run) {
  const auto last = marker.strip.last();
  if (!last) return 0;
  std::vector<bool> lies(marker.pieces.size());
  std::vector<std::size_t> off;
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    const Box box = box_of(placed_outline(marker, PieceId{static_cast<std::uint32_t>(i)}));
    lies[i] = box.high.x <= *last;
    if (!lies[i]) off.push_back(i);
  }
  std::stable_sort(off.begin(), off.end(),
                   [&set](std::size_t a, std::size_t b) { return set.kind(a).area > set.kind(b).area; });
  std::set<std::uint32_t> hopeless;  // kinds: once one of them does not fit, none does
  for (const std::size_t i : off) {
    if (run.stopped()) break;
    if (hopeless.contains(set.kind_of[i])) continue;
    if (auto placed = put_down(divided(marker, lies, false), marker.pieces[i], set.kind(i), run)) {
      marker.pieces[i] = *std::move(placed);
      lies[i] = true;
    } else {
      hopeless.insert(set.kind_of[i]);
    }
  }
  marker = divided(marker, lies, true);
  return marker.unplaced.size();
}

}  // namespace selvage::nesting
