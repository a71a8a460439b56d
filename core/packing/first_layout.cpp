#include "core/packing/first_layout.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"
#include "core/marker/validity.h"
#include "core/model/ties.h"
#include "core/motion/compaction/compact.h"

namespace selvage::packing {
namespace {

// Every free piece, or group of them, behind all that came before.
Marker in_a_row(const Marker& start) {
  Marker row = start;
  const model::Ties ties = model::ties_of(start);
  const marker::PlacedPieces pieces{start};
  const auto count = static_cast<std::uint32_t>(start.pieces.size());
  Coord end = start.strip.margin;
  for (std::uint32_t k = 0; k < count; ++k) {
    if (ties.x[k] == model::Ties::kFixed) end = std::max(end, pieces.box(k).high.x + pieces.widest_spacing());
  }
  std::vector<bool> moved(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    if (moved[k] || ties.x[k] == model::Ties::kFixed) continue;
    Box box = pieces.box(k);
    for (std::uint32_t other = k; other < count; ++other) {
      if (ties.x[other] == ties.x[k]) box = united(box, pieces.box(other));
    }
    const Vec by{end - box.low.x, ties.y[k] == model::Ties::kFixed ? 0 : start.strip.room(end).low.y - box.low.y};
    for (std::uint32_t other = k; other < count; ++other) {
      if (ties.x[other] != ties.x[k]) continue;
      row.pieces[other].at = row.pieces[other].at + by;
      moved[other] = true;
    }
    end += box.width() + pieces.widest_spacing();
  }
  return row;
}

// As they are turned, wherever they lie.
bool all_may_lie(const Marker& start) {
  return std::ranges::all_of(start.pieces,
                             [&](const Piece& piece) { return piece.rules.zone || may_lie(start, piece); });
}

}  // namespace

std::optional<Marker> rough_layout(const Marker& start) {
  if (!all_may_lie(start)) return std::nullopt;
  if (is_valid(start)) return start;
  Marker row = in_a_row(start);
  if (is_valid(row)) return row;
  return std::nullopt;
}

std::optional<Marker> first_layout(const Marker& start, const scene::Run& run) {
  if (!all_may_lie(start)) return std::nullopt;
  const auto settings = compaction_settings(motion::compaction::Accuracy::kStandard);
  for (const bool row : {false, true}) {
    auto compacted = compact(row ? in_a_row(start) : start, settings, run.quiet());
    if (compacted) return std::move(compacted->marker);
  }
  return std::nullopt;
}

}  // namespace selvage::packing
