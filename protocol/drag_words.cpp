#include "protocol/drag_words.h"

#include <algorithm>
#include <cmath>

#include "core/marker/figures.h"
#include "protocol/call_fields.h"
#include "protocol/codec.h"

namespace selvage {

Result<DragBegin> decode_drag_begin(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  DragBegin begin;
  begin.marker_id = fields.text("markerId");
  begin.piece = fields.id("piece");
  begin.mode = static_cast<DragMode>(fields.word_or("mode", 0, kDragModeNames));
  begin.base_revision = read_base_revision(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return begin;
}

Result<DragMove> decode_drag_move(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  DragMove move;
  move.drag_id = fields.text("dragId");
  const Json& to = fields.array("to");
  if (!mistake) move.to = read_point(to, fields.pointer("to"), mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return move;
}

Result<DragEnd> decode_drag_end(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  DragEnd end;
  end.drag_id = fields.text("dragId");
  end.marker_id = fields.text("markerId");
  end.commit = fields.flag_or("commit", end.commit);
  end.op_id = read_op_id(fields, mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return end;
}

Result<Vec> within_reach(const Decimal& to, const Marker& marker) {
  // Half the lattice: the piece's own extent comes on top.
  const double far = std::min(kFarthest * to_decimal(marker.strip.width, marker.resolution),
                              to_decimal(kLatticeLimit / 2, marker.resolution));
  for (const double coordinate : {to.x, to.y}) {
    if (std::abs(coordinate) <= far) continue;
    return Error{ErrorCode::kOutOfRange,
                 number_text(coordinate) + " is too far out; up to " + number_text(far) + " either way is allowed",
                 "/to"};
  }
  return Vec{to_lattice(to.x, marker.resolution), to_lattice(to.y, marker.resolution)};
}

Json drag_json(const Marker& before, const LaidOut& laid_out, const Drag& now, PieceId piece, Vec to) {
  const Vec at = now.marker.pieces[piece.value].at;
  const Figures figures = figures_after(before, laid_out, now.marker);
  return {{"at", point_json(at, now.marker.resolution)},
          {"reached", at == to},
          {"pushed", now.pushed},
          {"placements", changed_placements(before, now.marker)},
          {"length", to_decimal(figures.length, now.marker.resolution)},
          {"utilisation", figures.utilisation},
          {"valid", figures.valid}};
}

}  // namespace selvage
