#include "protocol/calls/values.h"

#include <algorithm>
#include <cmath>

namespace selvage::protocol::calls {

Point point_of(Vec at, Resolution resolution) {
  return {to_decimal(at.x, resolution), to_decimal(at.y, resolution)};
}

Point point_of(double x, double y, Resolution resolution) {
  return {formats::in_unit(x, resolution), formats::in_unit(y, resolution)};
}

Result<Vec> place_on_lattice(const Point& place, Resolution resolution, std::string_view field) {
  for (const double coordinate : {place.x, place.y}) {
    if (fits_lattice(coordinate, resolution)) continue;
    return Error{ErrorCode::kOutOfRange,
                 json::number_text(coordinate) + " is too far out; up to " +
                     json::number_text(to_decimal(kLatticeLimit - 1, resolution)) +
                     " in either direction is allowed, as far as the marker's lattice reaches",
                 std::string{field}};
  }
  return Vec{to_lattice(place.x, resolution), to_lattice(place.y, resolution)};
}

namespace {

Error unknown_piece(std::size_t pieces, const std::string& id, const std::string& field) {
  return {ErrorCode::kOutOfRange,
          json::shortened(Json(id)) + " is not a piece of this marker; the id of one of its " + std::to_string(pieces) +
              " pieces is allowed",
          field};
}

}  // namespace

Result<PieceId> piece_of(const Marker& marker, const std::string& id, const std::string& field) {
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    if (marker.pieces[i].id == id) return PieceId{i};
  }
  return unknown_piece(marker.pieces.size(), id, field);
}

PiecesById::PiecesById(const Marker& marker) {
  pieces_.reserve(marker.pieces.size());
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) pieces_.emplace(marker.pieces[i].id, PieceId{i});
}

Result<PieceId> PiecesById::piece_of(const std::string& id, const std::string& field) const {
  const auto found = pieces_.find(id);
  if (found != pieces_.end()) return found->second;
  return unknown_piece(pieces_.size(), id, field);
}

}  // namespace selvage::protocol::calls

namespace selvage::protocol::schema {
namespace {

const Component& direction_component() {
  static const Component kDirection{.name = "Direction",
                                    .meaning = "[x, y], with x along the strip and y across it; never [0, 0].",
                                    .same_as = pair_of({Type::Kind::kNumber})};
  return kDirection;
}

const Component& token_component() {
  static const Component kToken{.name = "ProgressToken",
                                .meaning = "Progress notifications carry this token; a string has at most 128 bytes.",
                                .same_as = either({{Type::Kind::kNumber}, {Type::Kind::kString}})};
  return kToken;
}

}  // namespace

Type Wire<calls::Direction>::type() {
  return {.kind = Type::Kind::kNamed, .component = &direction_component};
}

void Wire<calls::Direction>::read(const FieldAt& at, calls::Direction& value) {
  const std::string pointer = at.pointer();
  const Json& read = at.fields.array(at.key);
  if (at.mistake) return;
  if (read.size() != 2) {
    at.mistake.add(ErrorCode::kWrongType, json::shortened(read) + " where [x, y] is required", pointer);
    return;
  }
  constexpr json::Range kAllowed{-calls::kLargestForce, calls::kLargestForce};
  value = {checked_number(read[0], kAllowed, at.mistake, pointer + "/0"),
           checked_number(read[1], kAllowed, at.mistake, pointer + "/1")};
  if (std::max(std::abs(value.x), std::abs(value.y)) < calls::kLeastForce) {
    at.mistake.add(ErrorCode::kOutOfRange,
                   json::shortened(read) + " has no direction; [x, y] with x or y of at least " +
                       json::number_text(calls::kLeastForce) + " in absolute value is allowed",
                   pointer);
  }
}

Type Wire<calls::ProgressToken>::type() {
  return {.kind = Type::Kind::kNamed, .component = &token_component};
}

void Wire<calls::ProgressToken>::read(const FieldAt& at, calls::ProgressToken& value) {
  const Json* token = at.fields.maybe_any(at.key);
  const bool suits =
      token && (token->is_number() || (token->is_string() && token->text().size() <= calls::kLongestToken));
  if (suits) {
    value.value = *token;
    return;
  }
  at.mistake.add(ErrorCode::kWrongType,
                 json::shortened(token ? *token : Json{}) + " where a number, or a string of at most " +
                     std::to_string(calls::kLongestToken) + " bytes, is required",
                 at.pointer());
}

}  // namespace selvage::protocol::schema
