#include "protocol/edits/edits.h"

#include <utility>

#include "protocol/formats/constraints.h"
#include "protocol/formats/native.h"

namespace selvage::protocol::edits {
namespace {

constexpr json::Range kDegrees{-360, 360};
constexpr json::Range kTilts{-45, 45};

AddPiece read_add(json::Fields& op, json::Mistake& mistake) {
  AddPiece add;
  add.piece = formats::read_native_piece(op.object("piece"), op.pointer("piece"), mistake, add.attributes);
  if (const Json* shape = op.maybe_object("shape")) {
    add.shape = formats::read_native_shape(*shape, op.pointer("shape"), mistake, add.shape_attributes);
  }
  return add;
}

// One of two fields, the second of which adds to what is there: true when it is the second.
bool adds(json::Fields& op, std::string_view set, std::string_view add, json::Mistake& mistake) {
  if (op.has(set) && op.has(add)) {
    mistake.add(ErrorCode::kUnknownField, "either " + std::string{set} + " or " + std::string{add} + " is allowed",
                op.pointer(add));
  }
  return op.has(add);
}

MovePiece read_move(json::Fields& op, json::Mistake& mistake) {
  MovePiece move;
  move.piece = op.id("piece");
  move.by = adds(op, "at", "by", mistake);
  const std::string_view key = move.by ? "by" : "at";
  const Json& point = op.array(key);
  if (!mistake) move.to = formats::read_point(point, op.pointer(key), mistake);
  return move;
}

template <class Turn>
Turn read_turn(json::Fields& op, json::Range allowed, json::Mistake& mistake) {
  Turn turn;
  turn.piece = op.id("piece");
  turn.by = adds(op, "to", "by", mistake);
  turn.degrees = op.number(turn.by ? "by" : "to", allowed);
  return turn;
}

FlipPiece read_flip(json::Fields& op) {
  FlipPiece flip{op.id("piece"), std::nullopt};
  if (op.has("flip")) flip.flip = op.flag_or("flip", false);
  return flip;
}

LockPiece read_lock(json::Fields& op, json::Mistake& mistake) {
  LockPiece lock{op.id("piece"), {}};
  const Json* locked = op.maybe_any("locked");
  lock.locks = locked ? formats::locks_from(*locked, op.pointer("locked"), mistake) : Locks{true};
  return lock;
}

GroupPiece read_group(json::Fields& op) {
  GroupPiece group{op.id("piece"), {}};
  if (op.maybe_any("group")) group.group = op.id("group");
  return group;
}

SetStrip read_strip(json::Fields& op, json::Mistake& mistake) {
  SetStrip strip;
  strip.width = op.maybe_number("width", formats::kStripWidths);
  if (const Json* longest = op.maybe_any("longest")) {
    strip.longest.emplace();
    if (!longest->is_null()) {
      *strip.longest = checked_number(*longest, {0, formats::kStripWidths.most}, mistake, op.pointer("longest"));
    }
  }
  strip.margin = op.maybe_number("margin", {0, formats::kStripWidths.most});
  if (!strip.width && !strip.longest && !strip.margin) {
    mistake.add(ErrorCode::kMissingField, "width, longest or margin is required", op.pointer());
  }
  return strip;
}

Edit read_edit(const Json& value, const std::string& at, json::Mistake& mistake) {
  json::Fields op{value, at, mistake};
  if (!op.has("op")) (void)op.text("op");
  const std::size_t which = op.word_or("op", 0, kEditNames);
  if (mistake) return RemovePiece{};
  Edit edit;
  switch (which) {
    case 0: edit = read_add(op, mistake); break;
    case 1: edit = RemovePiece{op.id("piece")}; break;
    case 2: edit = read_move(op, mistake); break;
    case 3: edit = read_turn<RotatePiece>(op, kDegrees, mistake); break;
    case 4: edit = read_flip(op); break;
    case 5: edit = read_turn<TiltPiece>(op, kTilts, mistake); break;
    case 6: edit = read_lock(op, mistake); break;
    case 7: edit = read_group(op); break;
    case 8: edit = BufferPiece{op.id("piece"), op.number("buffer", {0, formats::kStripWidths.most})}; break;
    case 9: edit = read_strip(op, mistake); break;
    default: edit = SetSpacing{op.number("spacing", {0, formats::kStripWidths.most})}; break;
  }
  op.finish();
  return edit;
}

}  // namespace

std::vector<Edit> read_edits(json::Fields& fields, json::Mistake& mistake) {
  const Json& list = fields.array("ops");
  if (mistake) return {};
  if (list.empty() || list.size() > kMaxEdits) {
    mistake.add(ErrorCode::kOutOfRange,
                std::to_string(list.size()) + " operations; 1 to " + std::to_string(kMaxEdits) + " are allowed",
                fields.pointer("ops"));
  }
  std::vector<Edit> edits;
  for (std::size_t k = 0; k < list.size() && !mistake; ++k) {
    edits.push_back(read_edit(list[k], fields.pointer("ops") + "/" + std::to_string(k), mistake));
  }
  return edits;
}

}  // namespace selvage::protocol::edits
