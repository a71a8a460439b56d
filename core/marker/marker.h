// A marker: garment pieces on a strip of cloth [Li94 1.1.4].
//
// The strip is `width` across (along y, from 0) and runs along x from 0.  A marker's length is where its rightmost
// piece ends.  All coordinates are lattice units; Resolution says how long one is in the marker's own unit (usually
// mm). Invariant of a Marker that came through make_marker: ids are unique, every piece names a shape, every shape is a
// Polygon, every oriented piece fits the strip's width.  It need not be valid: see core/marker/validity.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/id.h"
#include "core/base/result.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"

namespace selvage::marker {

struct Strip {
  Coord width{};                   // across, along y
  std::optional<Coord> longest{};  // the cloth's end, when it has one: no piece may pass it
  Coord margin{};                  // pieces stay this far from the strip's edges, the cloth's end included

  // Where pieces may be, up to x = `end`.
  [[nodiscard]] constexpr Box room(Coord end) const { return {{margin, margin}, {end, width - margin}}; }
  // How far pieces may reach: nothing when the cloth has no end.
  [[nodiscard]] constexpr std::optional<Coord> last() const {
    return longest ? std::optional{*longest - margin} : std::nullopt;
  }
  // The same strip, with pieces reaching to `last` at most.
  [[nodiscard]] constexpr Strip ending(std::optional<Coord> last) const {
    return {width, last ? std::optional{*last + margin} : std::nullopt, margin};
  }
  friend bool operator==(const Strip&, const Strip&) = default;
};

// One pattern piece as it was drafted, in its own coordinates.
struct Shape {
  std::string id;
  Polygon outline;
  std::vector<Angle> rotations{Angle{}};  // allowed; empty: any
  bool may_flip{};
  Angle tilt_limit;  // largest |tilt|
  friend bool operator==(const Shape&, const Shape&) = default;
};

// What no motion may change of a piece.
struct Locks {
  bool x{}, y{}, tilt{};
  constexpr Locks() = default;
  constexpr Locks(bool all) : x{all}, y{all}, tilt{all} {}  // NOLINT(*-explicit-*): locked = true
  constexpr Locks(bool in_x, bool in_y, bool in_tilt) : x{in_x}, y{in_y}, tilt{in_tilt} {}
  [[nodiscard]] constexpr explicit operator bool() const { return x && y && tilt; }  // wholly
  friend constexpr auto operator<=>(const Locks&, const Locks&) = default;
};

// One copy of a shape, placed: the shape in its orientation, moved by `at`.
struct Piece {
  std::string id;
  ShapeId shape;
  Orientation orientation;
  Vec at;
  Locks locked{};
  std::string group{};  // pieces of one group move as one and do not tilt; empty: of none
  Coord buffer{};       // room kept about it: two pieces are no closer than the sum of their buffers
  friend bool operator==(const Piece&, const Piece&) = default;
};

struct Marker {
  std::string name;
  std::string unit{"mm"};
  Resolution resolution;
  Strip strip;
  Coord spacing{};  // least distance between any two pieces; 0: they may touch
  std::vector<Shape> shapes;
  std::vector<Piece> pieces;
  friend bool operator==(const Marker&, const Marker&) = default;
};

inline constexpr std::size_t kMaxPieces = 20'000;

// Checks the invariant above.  Errors: kEmptyMarker, kTooManyPieces, kDuplicateId, kUnknownShape, kPieceTooWide,
// kOrientationNotAllowed, kOutOfRange (strip width and margin, spacing, buffers); `field` is a JSON pointer into the
// native form.
[[nodiscard]] Result<Marker> make_marker(Marker marker);

// A piece's outline where it lies.
[[nodiscard]] Polygon placed_outline(const Marker& marker, PieceId piece);

// Where the rightmost piece ends.
[[nodiscard]] Coord length_of(const Marker& marker);
// The pieces' area over width times length, 0..1.
[[nodiscard]] double utilisation_of(const Marker& marker);

}  // namespace selvage::marker

// Vocabulary: named in selvage itself as well, so that every room may use it unqualified.
namespace selvage {
using marker::Locks;
using marker::Marker;
using marker::Piece;
using marker::Shape;
using marker::Strip;
}  // namespace selvage
