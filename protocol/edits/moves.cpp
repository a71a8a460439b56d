#include "protocol/edits/moves.h"

#include <utility>

#include "protocol/formats/native.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::edits {

std::optional<Moves> moves_between(const MarkerFile& before, const MarkerFile& after) {
  const std::vector<Piece>& from = before.marker.pieces;
  const std::vector<Piece>& to = after.marker.pieces;
  if (from.size() != to.size() || before.attributes.pieces != after.attributes.pieces ||
      before.attributes.unplaced != after.attributes.unplaced || before.attributes.shapes != after.attributes.shapes ||
      before.attributes.whole != after.attributes.whole) {
    return std::nullopt;
  }
  Moves moves;
  for (std::uint32_t i = 0; i < to.size(); ++i) {
    if (from[i].id != to[i].id || from[i].shape != to[i].shape) return std::nullopt;
    if (from[i] != to[i]) moves.push_back({i, to[i]});
  }
  // Everything else, including whatever is added to Marker later.
  Marker rest = before.marker;
  rest.pieces = to;
  if (rest != after.marker) return std::nullopt;
  return moves;
}

MarkerFile moved(MarkerFile file, const Moves& moves) {
  for (const Move& move : moves) file.marker.pieces[move.index] = move.piece;
  return file;
}

Json moves_json(const Marker& marker, const Moves& moves) {
  Json list = Json::array();
  for (const Move& move : moves) {
    list.push_back(Json::array({move.index, formats::native_piece(marker, move.piece, Json::object())}));
  }
  return list;
}

namespace {

Move read_move(const Json& value, const Marker& marker, json::Mistake& mistake) {
  const bool fine = value.is_array() && value.size() == 2 && value[0].is_number_unsigned() &&
                    value[0].get<std::uint64_t>() < marker.pieces.size();
  if (!fine) {
    mistake.add(ErrorCode::kWrongType, json::shortened(value) + " is not a move of a piece of this marker", "");
    return {};
  }
  const auto index = value[0].get<std::uint32_t>();
  const Piece& before = marker.pieces[index];
  Json attributes;
  formats::DecimalPiece read = formats::read_native_piece(value[1], "", mistake, attributes);
  if (mistake) return {};
  if (read.piece.id != before.id || read.shape != marker.shapes[before.shape.value].id) {
    mistake.add(ErrorCode::kUnknownShape, json::shortened(value) + " is a move of another piece", "");
    return {};
  }
  if (!fits_lattice(read.at.x, marker.resolution) || !fits_lattice(read.at.y, marker.resolution) ||
      !fits_lattice(read.buffer, marker.resolution) || !fits_lattice(read.overlap.value_or(0), marker.resolution) ||
      formats::beyond_lattice(read.rules, marker.resolution)) {
    mistake.add(ErrorCode::kBeyondLattice, json::shortened(value) + " lies beyond the lattice", "");
    return {};
  }
  Piece after = std::move(read.piece);
  after.shape = before.shape;
  after.at = {to_lattice(read.at.x, marker.resolution), to_lattice(read.at.y, marker.resolution)};
  after.buffer = formats::spacing_on_lattice(read.buffer, marker.resolution);
  if (read.overlap) after.overlap = formats::overlap_on_lattice(*read.overlap, marker.resolution);
  after.rules = formats::rules_on_lattice(read.rules, marker.resolution);
  return {index, std::move(after)};
}

}  // namespace

Result<Moves> read_moves(const Json& list, const Marker& marker) {
  if (!list.is_array()) return Error{ErrorCode::kWrongType, json::shortened(list) + " where moves are required", ""};
  json::Mistake mistake;
  Moves moves;
  for (const Json& value : list) {
    moves.push_back(read_move(value, marker, mistake));
    if (mistake) return mistake.error();
  }
  return moves;
}

}  // namespace selvage::protocol::edits
