// Edits: the operations of marker.apply, one after another, all or none.
//
// Words and numbers are checked when they are read, what they do to a marker when they are applied.  An edit may leave
// pieces overlapping or outside the strip: that is for motions to mend; what it leaves is always a well-formed marker.
// Coordinates are rounded to the marker's lattice, whose resolution stays.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::edits {

// {"op": "add", "piece": native piece, "shape"?: native shape, when the marker has none of that id}
struct AddPiece {
  formats::DecimalPiece piece;
  Json attributes;
  std::optional<formats::DecimalShape> shape;
  Json shape_attributes = Json::object();
};
// {"op": "remove", "piece"}
struct RemovePiece {
  std::string piece;
};
// {"op": "move", "piece", "at": [x, y]}, or "by"
struct MovePiece {
  std::string piece;
  formats::Decimal to;
  bool by{};
};
// {"op": "rotate", "piece", "to": degrees}, or "by"; about the shape's origin
struct RotatePiece {
  std::string piece;
  double degrees{};
  bool by{};
};
// {"op": "flip", "piece", "flip"?}; without "flip": the other way
struct FlipPiece {
  std::string piece;
  std::optional<bool> flip;
};
// {"op": "tilt", "piece", "to": degrees}, or "by"
struct TiltPiece {
  std::string piece;
  double degrees{};
  bool by{};
};
// {"op": "lock", "piece", "locked"?: true, false or a list of "x", "y", "tilt"}
struct LockPiece {
  std::string piece;
  Locks locks{true};
};
// {"op": "group", "piece", "group"?}; without "group": of none
struct GroupPiece {
  std::string piece, group;
};
// {"op": "buffer", "piece", "buffer"}
struct BufferPiece {
  std::string piece;
  double buffer{};
};
// {"op": "setStrip", "width"?, "longest"?: number or null, "margin"?}
struct SetStrip {
  std::optional<double> width, margin;
  std::optional<std::optional<double>> longest;  // a null takes the cloth's end away
};
// {"op": "setSpacing", "spacing"}
struct SetSpacing {
  double spacing{};
};

using Edit = std::variant<AddPiece, RemovePiece, MovePiece, RotatePiece, FlipPiece, TiltPiece, LockPiece, GroupPiece,
                          BufferPiece, SetStrip, SetSpacing>;

inline constexpr std::size_t kMaxEdits = 100'000;
inline constexpr std::string_view kEditNames[] = {
    "add",  "remove", "move",   "rotate",   "flip",      "tilt",
    "lock", "group",  "buffer", "setStrip", "setSpacing"};  // by Edit's index

// The field "ops" of a call: 1 to kMaxEdits edits.
[[nodiscard]] std::vector<Edit> read_edits(json::Fields& fields, json::Mistake& mistake);

// The file after all edits; its notes say what was mended in shapes that were added, `field` pointing into the
// parameters ("/ops/3/shape/outline").  Errors: those of make_marker, kOutOfRange for a piece that is not there,
// kBeyondLattice; `field` points at the operation, or into it.
[[nodiscard]] Result<MarkerFile> apply_edits(MarkerFile file, std::span<const Edit> edits);

}  // namespace selvage::protocol::edits
