#include "protocol/calls/piece_state.h"

namespace selvage::protocol::calls {

PieceState state_of(const Marker& marker, const Piece& piece) {
  PieceState state{.id = piece.id,
                   .shape = marker.shapes[piece.shape.value].id,
                   .at = point_of(piece.at, marker.resolution),
                   .rotation = piece.orientation.rotation.degrees,
                   .flip = piece.orientation.flip,
                   .tilt = piece.orientation.tilt.degrees,
                   .locked = piece.locked,
                   .group = {},
                   .buffer = {},
                   .overlap = {},
                   .rules = {}};
  if (!piece.group.empty()) state.group = piece.group;
  if (piece.buffer > 0) state.buffer = to_decimal(piece.buffer, marker.resolution);
  if (piece.overlap) state.overlap = to_decimal(*piece.overlap, marker.resolution);
  if (piece.rules != marker::Rules{}) state.rules = formats::decimal_rules(piece.rules, marker.resolution);
  return state;
}

}  // namespace selvage::protocol::calls

namespace selvage::protocol::schema {
namespace {

const Component& locks_component() {
  static const Component kLocks{
      .name = "Locks",
      .meaning = "True: the whole piece is locked; false: nothing is; or a list of the locked movements.",
      .same_as = either({{Type::Kind::kBoolean}, list_of(Wire<calls::LockedPart>::type())})};
  return kLocks;
}

}  // namespace

Type Wire<Locks>::type() {
  return {.kind = Type::Kind::kNamed, .component = &locks_component};
}

void Wire<Locks>::read(const FieldAt& at, Locks& value) {
  if (const Json* locked = at.fields.maybe_any(at.key)) value = formats::locks_from(*locked, at.pointer(), at.mistake);
}

}  // namespace selvage::protocol::schema
