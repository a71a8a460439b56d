// The full state of a piece, as it is listed in changes and by marker.get with `since`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "protocol/calls/values.h"
#include "protocol/formats/constraints.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::calls {

enum class LockedPart { kX, kY, kTilt };

}  // namespace selvage::protocol::calls

namespace selvage::protocol::schema {

template <>
struct Choices<calls::LockedPart> {
  static constexpr std::string_view kName = "LockedPart";
  static constexpr std::string_view kMeaning = "Which movements of a piece are locked.";
  static constexpr auto& kWords = formats::kLockNames;
};

template <>
struct Wire<Locks> {
  static Type type();
  static Json write(const Locks& value) { return formats::locks_json(value); }
  static void read(const FieldAt& at, Locks& value);
};

}  // namespace selvage::protocol::schema

namespace selvage::protocol::calls {

struct PieceState {
  static constexpr std::string_view kName = "PieceState", kMeaning = "A piece with its placement and its locks.";
  std::string id, shape;
  Point at;
  double rotation{};
  bool flip{};
  double tilt{};
  Locks locked;
  std::optional<std::string> group;
  std::optional<double> buffer, overlap;
  std::optional<formats::DecimalRules> rules;

  static void describe(auto& v, auto& self) {
    v.required("id", self.id, "The piece's id.");
    v.required("shape", self.shape, "Its shape's id.");
    v.required("at", self.at, "The position of the shape's origin.");
    v.required("rotation", self.rotation, "Degrees, counter-clockwise.");
    v.required("flip", self.flip, "Whether the piece is mirrored.");
    v.required("tilt", self.tilt, "Degrees, added to the rotation.");
    v.required("locked", self.locked, "Which movements are locked.");
    v.optional("group", self.group, "Its group, if it has one.");
    v.optional("buffer", self.buffer, "The clearance around it, if it has one.");
    v.optional("overlap", self.overlap, "Its own overlap allowance, if it has one.");
    v.optional("rules", self.rules, "Its own rules about where on the strip it may lie, if it has any.");
  }
};
[[nodiscard]] PieceState state_of(const Marker& marker, const Piece& piece);

}  // namespace selvage::protocol::calls
