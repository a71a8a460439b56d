// A marker: garment pieces laid out on a strip of cloth [Li94 1.1.4].
//
// The strip spans 0 to `width` along y and starts at x = 0.  A marker's length is the x coordinate at which its
// rightmost piece ends.  All coordinates are in lattice units; Resolution gives the length of a unit in the marker's
// own unit (usually mm).
// A marker may also have pieces that do not lie on the cloth: they are listed apart from the placed ones and have no
// position.  Length, utilisation, validity and motions concern placed pieces only; nesting places the others.
// Invariant of a Marker that make_marker returned: ids are unique, also between placed and unplaced pieces; every piece
// names an existing shape, every shape is a Polygon, every piece has an orientation that its shape allows, every placed
// piece fits the strip's width and the room that its rules leave, every part of a piece (rules.h) is a Polygon with its
// corners within the piece's outline, and every zone is placed and locked. Pieces may still overlap or leave the strip
// or their rooms: see core/marker/validity.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/id.h"
#include "core/base/result.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"
#include "core/marker/rules.h"

namespace selvage::marker {

struct Strip {
  Coord width{};                   // along y
  std::optional<Coord> longest{};  // the length of the cloth if it is limited: no piece may extend beyond it
  Coord margin{};  // distance that pieces keep from the strip's long edges and from the ends of the cloth
  std::optional<Coord> below{},
      above{};      // the selvedges: distances from the lower and the upper edge; none: the margin
  Repeat repeat{};  // of the cloth's pattern, which pieces with a match point keep
  bool tube{};      // tubular cloth: the upper edge is a fold, too, as the lower one is for pieces that lie on it

  // The box in which pieces may lie, up to x = `end`, unless they have rules of their own (core/marker/rules.h).
  [[nodiscard]] constexpr Box room(Coord end) const {
    return {{margin, below.value_or(margin)}, {end, width - above.value_or(margin)}};
  }
  // The largest x that a piece may reach; nothing when the length of the cloth is not limited.
  [[nodiscard]] constexpr std::optional<Coord> last() const {
    return longest ? std::optional{*longest - margin} : std::nullopt;
  }
  // The same strip, limited so that pieces reach at most x = `last`; nothing removes the limit.
  [[nodiscard]] constexpr Strip ending(std::optional<Coord> last) const {
    Strip same = *this;
    same.longest = last ? std::optional{*last + margin} : std::nullopt;
    return same;
  }
  friend bool operator==(const Strip&, const Strip&) = default;
};

// One pattern piece as it was drafted, in its own coordinates.
struct Shape {
  std::string id;
  Polygon outline;
  std::vector<Angle> rotations{Angle{}};  // the allowed rotations; empty: any rotation is allowed
  bool may_flip{};
  Angle tilt_limit;  // the largest absolute tilt
  friend bool operator==(const Shape&, const Shape&) = default;
};

// The degrees of freedom of a piece that no operation may change.
struct Locks {
  bool x{}, y{}, tilt{};
  constexpr Locks() = default;
  constexpr Locks(bool all) : x{all}, y{all}, tilt{all} {}  // NOLINT(*-explicit-*): locked = true
  constexpr Locks(bool in_x, bool in_y, bool in_tilt) : x{in_x}, y{in_y}, tilt{in_tilt} {}
  [[nodiscard]] constexpr explicit operator bool() const { return x && y && tilt; }  // true when all are locked
  friend constexpr auto operator<=>(const Locks&, const Locks&) = default;
};

// A placed copy of a shape: the shape in its orientation, translated by `at`.
struct Piece {
  std::string id;
  ShapeId shape;
  Orientation orientation;
  Vec at;
  Locks locked{};
  std::string group{};  // pieces of one group move together and do not tilt; empty: no group
  Coord buffer{};       // clearance around the piece: two pieces are never closer than the sum of their buffers
  std::optional<Coord> overlap{};  // its own overlap allowance; none: the marker's
  Rules rules{};                   // where on the strip it may lie
  friend bool operator==(const Piece&, const Piece&) = default;
};

struct Marker {
  std::string name;
  std::string unit{"mm"};
  Resolution resolution;
  Strip strip;
  Coord spacing{};  // the least distance between two pieces; 0: pieces may touch
  Coord overlap{};  // the overlap allowance: two pieces may overlap when a translation of one of them by at most this
                    // separates them.  A pair is allowed the smaller of its two allowances, and none when a spacing or
                    // buffers keep it apart; the strip's edges allow none
  std::optional<Coord> shade{};  // the length along x within which the pieces of one shade lie; none: any
  std::vector<Shape> shapes;
  std::vector<Piece> pieces;
  std::vector<Piece> unplaced{};  // pieces that do not lie on the cloth; their position is 0 and means nothing
  friend bool operator==(const Marker&, const Marker&) = default;
};

inline constexpr std::size_t kMaxPieces = 20'000;  // placed and unplaced ones together

// Checks the invariant above.
// Errors: kEmptyMarker, kTooManyPieces, kDuplicateId, kUnknownShape, kPieceTooWide, kOrientationNotAllowed, kOutOfRange
// (strip width, margin, selvedges, spacing, buffers, overlap allowances, rules), and those of clean_polygon for an
// outline that is no Polygon once turned. `field` is a JSON pointer into the native format.
[[nodiscard]] Result<Marker> make_marker(Marker marker);

// A piece's outline at its position and in its orientation.
[[nodiscard]] Polygon placed_outline(const Marker& marker, PieceId piece);

// The match point of a piece as it is turned, relative to the piece's position and rounded to the lattice like the
// vertices of the outline; 0 when it has none.
[[nodiscard]] Vec turned_match(const Piece& piece);

// The part of a piece that accepts less of the cloth's quality (rules.h), as it is turned, relative to the piece's
// position and rounded like the outline; empty when it has none.
[[nodiscard]] Polygon turned_part(const Piece& piece);
// False when rounding made the turned part touch itself.
[[nodiscard]] bool part_is_polygon(const Piece& piece);

// The number of placed pieces, without the zones that are listed among them (rules.h).
[[nodiscard]] std::size_t piece_count(const Marker& marker);
// The x coordinate at which the rightmost piece ends; lattice units.
[[nodiscard]] Coord length_of(const Marker& marker);
// The area of the pieces divided by the area of the strip up to the marker's length, 0..1.
[[nodiscard]] double utilisation_of(const Marker& marker);

}  // namespace selvage::marker

// Basic types: also available in namespace selvage, so that every folder can use them unqualified.
namespace selvage {
using marker::Locks;
using marker::Marker;
using marker::Piece;
using marker::Shape;
using marker::Strip;
}  // namespace selvage
