// Edits: the operations of marker.apply, applied in order, all or none.
//
// Words and numbers are checked when they are read; their effect on a marker is checked when they are applied.  An edit
// may leave pieces overlapping or outside the strip, which motions then repair; the marker is always well formed.
// Coordinates are rounded to the marker's lattice, whose resolution does not change.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "protocol/calls/piece_state.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/schema/documents.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::edits {

inline constexpr std::string_view kOpMeaning = "The operation.";
inline constexpr std::string_view kPieceMeaning = "The piece's id.";
inline constexpr std::string_view kUnplacedMeaning = "The unplaced piece's id.";
inline constexpr schema::Limits kDegrees{.range = {{-360, 360}}}, kTilts{.range = {{-45, 45}}};
inline constexpr schema::Limits kLengths{.range = {{0, formats::kStripWidths.most}}};

// A piece and a shape as in a native document.
struct NativePiece {
  formats::DecimalPiece piece;
  Json attributes;
};
struct NativeShape {
  formats::DecimalShape shape;
  Json attributes = Json::object();
};
// A length, or null.
struct NullableLength {
  std::optional<double> value;
};

// Exactly one of two fields is required.
inline auto one_of(std::string_view set, std::string_view add) {
  return [set, add](json::Fields& op, json::Mistake& mistake) {
    if (op.has(set) && op.has(add)) {
      mistake.add(ErrorCode::kUnknownField, "either " + std::string{set} + " or " + std::string{add} + " is allowed",
                  op.pointer(add));
    } else if (!op.has(set) && !op.has(add)) {
      (void)op.required_any(set);
    }
  };
}

struct AddPiece {
  static constexpr std::string_view kOp = "add", kName = "AddEdit", kMeaning = "Adds a piece after the other pieces.";
  NativePiece piece;
  std::optional<NativeShape> shape;

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, "As in a native document.");
    v.optional("shape", self.shape, "As in a native document, when the marker has no shape with this id.");
  }
};
struct RemovePiece {
  static constexpr std::string_view kOp = "remove", kName = "RemoveEdit",
                                    kMeaning = "Removes a piece, placed or not; its shape stays.";
  calls::Id piece;

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kPieceMeaning);
  }
};
struct PlacePiece {
  static constexpr std::string_view kOp = "place", kName = "PlaceEdit",
                                    kMeaning = "Lays an unplaced piece on the cloth, after the other pieces.";
  calls::Id piece;
  calls::Point at{};
  std::optional<double> rotation;  // degrees
  std::optional<bool> flip;

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kUnplacedMeaning);
    v.required("at", self.at, "The position of its origin.");
    v.optional("rotation", self.rotation, "A rotation that the shape allows; unchanged when absent.", kDegrees);
    v.optional("flip", self.flip, "Whether it is mirrored; unchanged when absent.");
  }
};
struct TakeOffPiece {
  static constexpr std::string_view kOp = "takeOff", kName = "TakeOffEdit",
                                    kMeaning = "Takes a piece off the cloth: it becomes the last unplaced piece.";
  calls::Id piece;

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kPieceMeaning);
  }
};
struct MovePiece {
  static constexpr std::string_view
      kOp = "move",
      kName = "MoveEdit",
      kMeaning = "Moves a piece to a position (at) or by a distance (by); one of these is required.";
  calls::Id piece;
  std::optional<calls::Point> at, by;

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kPieceMeaning);
    v.optional("at", self.at, "The new position of its origin.");
    v.optional("by", self.by, "The displacement.");
    v.check(one_of("at", "by"));
  }
};
struct RotatePiece {
  static constexpr std::string_view kOp = "rotate", kName = "RotateEdit",
                                    kMeaning =
                                        "Rotates a piece about its shape's origin, to a rotation that the shape "
                                        "allows: to or by is required.";
  calls::Id piece;
  std::optional<double> to, by;  // degrees

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kPieceMeaning);
    v.optional("to", self.to, "The new rotation in degrees.", kDegrees);
    v.optional("by", self.by, "Degrees added to the rotation.", kDegrees);
    v.check(one_of("to", "by"));
  }
};
struct FlipPiece {
  static constexpr std::string_view kOp = "flip", kName = "FlipEdit", kMeaning = "Mirrors a piece.";
  calls::Id piece;
  std::optional<bool> flip;

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kPieceMeaning);
    v.optional("flip", self.flip, "Whether the piece is mirrored afterwards; toggled when absent.");
  }
};
struct TiltPiece {
  static constexpr std::string_view kOp = "tilt", kName = "TiltEdit",
                                    kMeaning = "Tilts a piece within its shape's tilt limit; to or by is required.";
  calls::Id piece;
  std::optional<double> to, by;  // degrees

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kPieceMeaning);
    v.optional("to", self.to, "The new tilt in degrees.", kTilts);
    v.optional("by", self.by, "Degrees added to the tilt.", kTilts);
    v.check(one_of("to", "by"));
  }
};
struct LockPiece {
  static constexpr std::string_view kOp = "lock", kName = "LockEdit",
                                    kMeaning = "Locks a piece, so that no motion moves it, or unlocks it.";
  calls::Id piece;
  Locks locks{true};

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kPieceMeaning);
    v.optional("locked", self.locks, "Which movements are locked; the whole piece when absent.");
  }
};
struct GroupPiece {
  static constexpr std::string_view kOp = "group", kName = "GroupEdit",
                                    kMeaning = "Puts a piece into a group; the pieces of a group move as one.";
  calls::Id piece;
  std::optional<calls::Id> group;

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kPieceMeaning);
    v.optional("group", self.group, "The group; when absent, the piece is removed from its group.");
  }
};
struct BufferPiece {
  static constexpr std::string_view kOp = "buffer", kName = "BufferEdit",
                                    kMeaning = "Sets the clearance around a piece.";
  calls::Id piece;
  double buffer{};

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kPieceMeaning);
    v.required("buffer", self.buffer, "A length.", kLengths);
  }
};
struct OverlapPiece {
  static constexpr std::string_view kOp = "overlap", kName = "OverlapEdit",
                                    kMeaning = "Sets the overlap allowance of a piece.";
  calls::Id piece;
  std::optional<double> overlap;

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kPieceMeaning);
    v.optional("overlap", self.overlap, "A length; when absent, the marker's allowance applies to the piece.",
               kLengths);
  }
};
struct RulesOfPiece {
  static constexpr std::string_view kOp = "rules", kName = "RulesEdit",
                                    kMeaning = "Sets the rules of a piece: where on the strip it may lie.";
  calls::Id piece;
  std::optional<formats::DecimalRules> rules;

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("piece", self.piece, kPieceMeaning);
    v.optional("rules", self.rules, "The complete rules of the piece; it has none when absent.");
  }
};
struct SetStrip {
  static constexpr std::string_view kOp = "setStrip", kName = "StripEdit",
                                    kMeaning = "Changes the strip; at least one of its fields is required.";
  std::optional<double> width;
  std::optional<NullableLength> longest;  // null: the cloth has no end
  std::optional<double> margin;
  std::optional<NullableLength> below, above;  // null: the margin holds there
  std::optional<formats::DecimalRepeat> repeat;
  std::optional<bool> tube;

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.optional("width", self.width, "The width of the strip.", {.range = formats::kStripWidths});
    v.optional("longest", self.longest, "The x coordinate where the cloth ends; null for cloth without end.", kLengths);
    v.optional("margin", self.margin, "The distance that pieces keep from the strip's edges.", kLengths);
    v.optional("below", self.below, "The distance from the lower edge; null for the margin.", kLengths);
    v.optional("above", self.above, "The distance from the upper edge; null for the margin.", kLengths);
    v.optional("repeat", self.repeat, "The pattern of the cloth; {} for none.");
    v.optional("tube", self.tube, "Whether the cloth is a tube, whose upper edge is a fold, too.");
    v.check([](const json::Fields& op, json::Mistake& mistake) {
      for (const std::string_view field : {"width", "longest", "margin", "below", "above", "repeat", "tube"}) {
        if (op.has(field)) return;
      }
      mistake.add(ErrorCode::kMissingField, "width, longest, margin, below, above, repeat or tube is required",
                  op.pointer());
    });
  }
};
struct SetSpacing {
  static constexpr std::string_view kOp = "setSpacing", kName = "SpacingEdit",
                                    kMeaning = "Sets the least distance between two pieces.";
  double spacing{};

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("spacing", self.spacing, "A length.", kLengths);
  }
};
struct SetOverlap {
  static constexpr std::string_view kOp = "setOverlap", kName = "AllowanceEdit",
                                    kMeaning = "Sets the marker's overlap allowance.";
  double overlap{};

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("overlap", self.overlap, "A length.", kLengths);
  }
};
struct SetShade {
  static constexpr std::string_view kOp = "setShade", kName = "ShadeEdit",
                                    kMeaning =
                                        "Sets the length along the strip within which the pieces of a shade lie.";
  NullableLength shade;

  static void describe(auto& v, auto& self) {
    v.constant("op", kOp, kOpMeaning);
    v.required("shade", self.shade, "A length; null if shades have no effect.", kLengths);
  }
};

using Edit = std::variant<AddPiece, RemovePiece, PlacePiece, TakeOffPiece, MovePiece, RotatePiece, FlipPiece, TiltPiece,
                          LockPiece, GroupPiece, BufferPiece, OverlapPiece, RulesOfPiece, SetStrip, SetSpacing,
                          SetOverlap, SetShade>;

inline constexpr std::size_t kMaxEdits = 100'000;

[[nodiscard]] schema::Type edit_type();
// Errors: 10xx, `field` is a JSON pointer below `at`.
[[nodiscard]] Edit read_edit(const Json& value, const std::string& at, json::Mistake& mistake);

// The file after all edits; its notes list the repairs of shapes that were added, `field` pointing into the parameters
// ("/ops/3/shape/outline").  Errors: those of make_marker, kOutOfRange for a piece that the marker does not have,
// kBeyondLattice; `field` points at the operation, or into it.
[[nodiscard]] Result<MarkerFile> apply_edits(MarkerFile file, std::span<const Edit> edits);

}  // namespace selvage::protocol::edits

namespace selvage::protocol::schema {

template <>
struct Wire<edits::NativePiece> {
  static Type type() { return native("PieceDocument"); }
  static void read(const FieldAt& at, edits::NativePiece& value);
};
template <>
struct Wire<edits::NativeShape> {
  static Type type() { return native("ShapeDocument"); }
  static void read(const FieldAt& at, edits::NativeShape& value);
};
template <>
struct Wire<edits::NullableLength> {
  static Type type() { return either({{Type::Kind::kNumber}, {Type::Kind::kNull}}); }
  static void read(const FieldAt& at, edits::NullableLength& value);
};
template <>
struct Wire<edits::Edit> {
  static Type type() { return edits::edit_type(); }
  static edits::Edit read_entry(const Json& value, const std::string& at, json::Mistake& mistake) {
    return edits::read_edit(value, at, mistake);
  }
};

}  // namespace selvage::protocol::schema
