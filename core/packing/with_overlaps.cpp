#include "core/packing/with_overlaps.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/nesting/nest.h"
#include "core/packing/bodies/bodies.h"

namespace selvage::packing {
namespace {

using outline::enclosed::Container;

nesting::NestSettings nesting_of(std::size_t pieces, const OverlapSettings& settings) {
  nesting::NestSettings nest;
  nest.moves = settings.moves_a_piece * pieces;
  nest.tilts = false;
  return nest;
}

// What of the box lies outside of the inner one: up to four rectangles.
std::vector<Polygon> around(const Box& inner, const Box& box) {
  std::vector<Polygon> sides;
  const auto add = [&sides](Vec low, Vec high) {
    if (low.x < high.x && low.y < high.y) sides.push_back({low, {high.x, low.y}, high, {low.x, high.y}});
  };
  add(box.low, {inner.low.x, box.high.y});
  add({inner.high.x, box.low.y}, box.high);
  add({inner.low.x, box.low.y}, {inner.high.x, inner.low.y});
  add({inner.low.x, inner.high.y}, {inner.high.x, box.high.y});
  return sides;
}

// The class of the cloth outside a container: worse than any that a piece to be placed accepts.
constexpr marker::Quality kOutside = marker::kWorstQuality + 1;

// The wanted pieces off the cloth, the others locked, and zones wherever the cloth is not in the container.  The others
// may lie on these.
Marker around_container(const Marker& start, const std::vector<bool>& moving, const Container& container) {
  Marker marker = start;
  marker.pieces.clear();
  marker.unplaced.clear();
  const marker::PlacedPieces pieces{start};
  Coord end = container.box.high.x;
  std::size_t longest_id = 0;
  for (std::uint32_t k = 0; k < pieces.size(); ++k) {
    Piece piece = start.pieces[k];
    longest_id = std::max(longest_id, piece.id.size());
    if (moving[k]) {
      marker.unplaced.push_back(std::move(piece));
      continue;
    }
    if (!piece.rules.zone) {
      piece.rules.quality = kOutside;
      piece.rules.part.reset();
      end = std::max(end, pieces.end_of(k));
    }
    piece.locked = true;
    marker.pieces.push_back(std::move(piece));
  }
  marker.strip = marker.strip.ending(std::min(end, start.strip.last().value_or(end)));
  std::vector<Polygon> outside = around(container.box, {{0, 0}, {end, marker.strip.width}});
  outside.insert(outside.end(), container.walls.begin(), container.walls.end());
  for (Polygon& wall : outside) {
    const ShapeId shape{static_cast<std::uint32_t>(marker.shapes.size())};
    const std::string id = std::string(longest_id + 1, '-') + std::to_string(shape.value);  // longer than the others
    marker.pieces.push_back({.id = id,
                             .shape = shape,
                             .orientation = {},
                             .at = {},
                             .locked = true,
                             .rules = {.zone = true, .quality = kOutside}});
    marker.shapes.push_back({.id = id, .outline = std::move(wall), .tilt_limit = {}});
  }
  return marker;
}

}  // namespace

bool nests_as_searched(const Marker& marker, const Piece& piece, bool turns) {
  const Shape& shape = marker.shapes[piece.shape.value];
  const bool listed = turns ? !shape.rotations.empty() : shape.rotations.size() == 1 && !shape.may_flip;
  return listed && piece.orientation.tilt == Angle{};
}

std::optional<Marker> packed_with_overlaps(const Marker& start, const OverlapSettings& settings,
                                           const scene::Run& run) {
  std::optional<Marker> best;
  const bool placed = start.unplaced.empty();
  const auto shorter = [&](const Marker& marker) {
    if (best || (placed && is_valid(start))) return length_of(marker) < length_of(best ? *best : start);
    return true;
  };
  if (placed) {
    auto compacted = compact(start, compaction_settings(motion::compaction::Accuracy::kStandard), run.quiet());
    if (compacted && shorter(compacted->marker)) best = std::move(compacted->marker);
  }
  const auto as_searched = [&](const Piece& piece) { return nests_as_searched(start, piece, settings.turns); };
  if (run.stopped() || settings.moves_a_piece == 0 || !std::ranges::all_of(start.pieces, as_searched) ||
      !std::ranges::all_of(start.unplaced, as_searched)) {
    return best;
  }
  const std::size_t count = start.pieces.size() + start.unplaced.size();
  auto nested = nest(best ? *best : start, nesting_of(count, settings), run.quiet());
  if (nested && nested->left_over == 0 && shorter(nested->marker)) best = std::move(nested->marker);
  return best;
}

std::optional<Marker> contained_with_overlaps(const Marker& start, std::span<const PieceId> wanted,
                                              const Container& container, const OverlapSettings& settings,
                                              const scene::Run& run) {
  std::vector<bool> moving(start.pieces.size());
  for (const PieceId id : wanted) {
    const Piece& piece = start.pieces[id.value];
    if (piece.locked.x && piece.locked.y) continue;
    const bool free = !piece.locked.x && !piece.locked.y && !piece.locked.tilt && piece.group.empty();
    if (!free || !nests_as_searched(start, piece, settings.turns)) return std::nullopt;
    moving[id.value] = true;
  }
  const Marker room = around_container(start, moving, container);
  Marker whole = start;
  if (!room.unplaced.empty()) {
    if (run.stopped() || settings.moves_a_piece == 0) return std::nullopt;
    auto nested = nest(room, nesting_of(room.unplaced.size(), settings), run.quiet());
    if (!nested || nested->left_over > 0) return std::nullopt;
    std::unordered_map<std::string_view, const Piece*> places;
    for (const Piece& piece : nested->marker.pieces) places.emplace(piece.id, &piece);
    for (std::size_t k = 0; k < moving.size(); ++k) {
      if (!moving[k]) continue;
      const Piece& now = *places.at(whole.pieces[k].id);
      whole.pieces[k].orientation = now.orientation;
      whole.pieces[k].at = now.at;
    }
  }
  const marker::PlacedPieces pieces{whole};
  std::vector<std::uint32_t> changed;
  for (const PieceId id : wanted) changed.push_back(id.value);
  const bodies::Freedom freedom{moving, container, settings.turns, 0};
  const auto inside = [&](std::uint32_t piece) { return bodies::lies_inside(whole, pieces, piece, freedom); };
  const bool proved = std::ranges::all_of(changed, inside) && keep_joint_rules(pieces) && are_clear(pieces, changed);
  return proved ? std::optional{std::move(whole)} : std::nullopt;
}

}  // namespace selvage::packing
