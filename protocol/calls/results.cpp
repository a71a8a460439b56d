#include "protocol/calls/results.h"

#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::calls {

std::vector<Note> notes_of(const std::vector<selvage::Note>& notes) {
  std::vector<Note> list;
  for (const selvage::Note& note : notes) list.push_back({note.field, note.text});
  return list;
}

std::vector<Placement> changed_placements(const Marker& before, const Marker& after) {
  std::vector<Placement> changed;
  auto was = before.pieces.begin();
  for (const Piece& piece : after.pieces) {
    while (was != before.pieces.end() && was->id != piece.id) ++was;
    if (was != before.pieces.end() && piece.at == was->at && piece.orientation == was->orientation) continue;
    changed.push_back({.id = piece.id,
                       .at = point_of(piece.at, after.resolution),
                       .rotation = piece.orientation.rotation.degrees,
                       .flip = piece.orientation.flip,
                       .tilt = piece.orientation.tilt.degrees});
  }
  return changed;
}

std::vector<Overlap> overlaps_of(const Marker& marker, const std::vector<marker::Overlap>& overlaps) {
  std::vector<Overlap> list;
  for (const marker::Overlap& overlap : overlaps) {
    list.push_back({.first = marker.pieces[overlap.first.value].id,
                    .second = marker.pieces[overlap.second.value].id,
                    .witness = point_of(overlap.witness_x, overlap.witness_y, marker.resolution),
                    .depth = formats::in_unit(overlap.depth, marker.resolution)});
  }
  return list;
}

std::vector<Protrusion> protrusions_of(const Marker& marker, const std::vector<marker::Protrusion>& protrusions) {
  std::vector<Protrusion> list;
  for (const marker::Protrusion& protrusion : protrusions) {
    list.push_back({marker.pieces[protrusion.piece.value].id, to_decimal(protrusion.by, marker.resolution)});
  }
  return list;
}

Healing healing_of(const motion::repair::Repair& repair, Resolution resolution) {
  return {.pairs = repair.pairs,
          .protruding = repair.protruding,
          .deepest = formats::in_unit(repair.deepest, resolution),
          .farthest_move = to_decimal(repair.farthest_move, resolution),
          .lengthened = to_decimal(repair.lengthened, resolution)};
}

StageTimes stage_times_of(const execution::StageTimes& times) {
  return {times.decomposition, times.sums, times.rows, times.solve, times.verify, times.total};
}

CacheCounts cache_counts_of(const minkowski::CacheCounts& counts) {
  return {.hits = static_cast<std::size_t>(counts.hits),
          .misses = static_cast<std::size_t>(counts.misses),
          .entries = counts.entries,
          .bytes = counts.bytes,
          .limit = counts.limit};
}

}  // namespace selvage::protocol::calls
