#include "protocol/methods/readings/drag_messages.h"

#include <algorithm>
#include <cmath>

#include "core/marker/figures.h"
#include "protocol/calls/call_fields.h"
#include "protocol/calls/codec.h"

namespace selvage::protocol::methods::readings {

Result<DragBegin> decode_drag_begin(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  DragBegin begin;
  begin.marker_id = fields.text("markerId");
  begin.piece = fields.id("piece");
  begin.mode = static_cast<motion::dragging::DragMode>(fields.word_or("mode", 0, kDragModeNames));
  begin.base_revision = calls::read_base_revision(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return begin;
}

Result<DragMove> decode_drag_move(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  DragMove move;
  move.drag_id = fields.text("dragId");
  const Json& to = fields.array("to");
  if (!mistake) move.to = formats::read_point(to, fields.pointer("to"), mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return move;
}

Result<DragEnd> decode_drag_end(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  DragEnd end;
  end.drag_id = fields.text("dragId");
  end.marker_id = fields.text("markerId");
  end.commit = fields.flag_or("commit", end.commit);
  end.op_id = calls::read_op_id(fields, mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return end;
}

Result<Vec> within_reach(const formats::Decimal& to, const Marker& marker) {
  // Half the lattice: the piece's own extent comes on top.
  const double far = std::min(formats::kFarthest * to_decimal(marker.strip.width, marker.resolution),
                              to_decimal(kLatticeLimit / 2, marker.resolution));
  for (const double coordinate : {to.x, to.y}) {
    if (std::abs(coordinate) <= far) continue;
    return Error{
        ErrorCode::kOutOfRange,
        json::number_text(coordinate) + " is too far out; up to " + json::number_text(far) + " either way is allowed",
        "/to"};
  }
  return Vec{to_lattice(to.x, marker.resolution), to_lattice(to.y, marker.resolution)};
}

Json drag_json(const Marker& before, const scene::LaidOut& laid_out, const motion::dragging::Drag& now, PieceId piece,
               Vec to) {
  const Vec at = now.marker.pieces[piece.value].at;
  const marker::Figures figures = figures_after(before, laid_out, now.marker);
  return {{"at", formats::point_json(at, now.marker.resolution)},
          {"reached", at == to},
          {"pushed", now.pushed},
          {"placements", calls::changed_placements(before, now.marker)},
          {"length", to_decimal(figures.length, now.marker.resolution)},
          {"utilisation", figures.utilisation},
          {"valid", figures.valid}};
}

}  // namespace selvage::protocol::methods::readings
