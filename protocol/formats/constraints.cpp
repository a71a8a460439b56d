#include "protocol/formats/constraints.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace selvage::protocol::formats {
namespace {

void lock_one(const Json& name, Locks& locks, const std::string& at, json::Mistake& mistake) {
  const auto* const word = std::find(std::begin(kLockNames), std::end(kLockNames), name);
  if (word == std::end(kLockNames)) {
    mistake.add(ErrorCode::kOutOfRange, json::shortened(name) + " cannot be locked; x, y and tilt can", at);
    return;
  }
  const std::array<bool*, 3> flags{&locks.x, &locks.y, &locks.tilt};
  *flags[static_cast<std::size_t>(word - std::begin(kLockNames))] = true;
}

}  // namespace

Locks locks_from(const Json& value, const std::string& at, json::Mistake& mistake) {
  if (value.is_boolean()) return Locks{value.get<bool>()};
  Locks locks;
  if (!value.is_array()) {
    mistake.add(ErrorCode::kWrongType,
                json::shortened(value) + R"( where true, false or a list of "x", "y", "tilt" is required)", at);
    return locks;
  }
  for (std::size_t k = 0; k < value.size() && !mistake; ++k)
    lock_one(value[k], locks, at + "/" + std::to_string(k), mistake);
  return locks;
}

Json locks_json(const Locks& locks) {
  if (locks == Locks{true} || locks == Locks{}) return locks == Locks{true};
  Json names = Json::array();
  for (const auto& [on, name] :
       {std::pair{locks.x, kLockNames[0]}, {locks.y, kLockNames[1]}, {locks.tilt, kLockNames[2]}}) {
    if (on) names.push_back(name);
  }
  return names;
}

void read_constraints(json::Fields& fields, json::Mistake& mistake, DecimalPiece& piece) {
  if (const Json* locked = fields.maybe_any("locked")) {
    piece.piece.locked = locks_from(*locked, fields.pointer("locked"), mistake);
  }
  if (fields.maybe_any("group") != nullptr) piece.piece.group = fields.id("group");
  piece.buffer = fields.number_or("buffer", 0, {0, kStripWidths.most});
  piece.overlap = fields.maybe_number("overlap", {0, kStripWidths.most});
  if (const Json* rules = fields.maybe_object("rules")) {
    piece.rules = schema::decode_at<DecimalRules>(*rules, fields.pointer("rules"), mistake);
  }
}

void write_constraints(Json& json, const Marker& marker, const Piece& piece) {
  if (piece.locked != Locks{}) json["locked"] = locks_json(piece.locked);
  if (!piece.group.empty()) json["group"] = piece.group;
  if (piece.buffer > 0) json["buffer"] = to_decimal(piece.buffer, marker.resolution);
  if (piece.overlap) json["overlap"] = to_decimal(*piece.overlap, marker.resolution);
  if (piece.rules != marker::Rules{}) json["rules"] = schema::encode(decimal_rules(piece.rules, marker.resolution));
}

}  // namespace selvage::protocol::formats
