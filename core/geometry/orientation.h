// The orientation of a piece: a flip, then a rotation, then a tilt [Li94 1.1.4; design: numbers].
//
// Flips and multiples of 90 degrees map the lattice onto itself.  They form the eight Symmetries and are exact.  The
// rest of the angle is a turn of at most 45 degrees.  A turned shape is rounded to the lattice once, and from then on
// the rounded polygon is the piece's outline.
#pragma once

#include <compare>
#include <cstdint>

#include "core/geometry/polygon.h"

namespace selvage::geometry {

// Degrees, counter-clockwise.
struct Angle {
  double degrees{};
  [[nodiscard]] static constexpr Angle of_degrees(double value) { return {value}; }
  friend constexpr auto operator<=>(const Angle&, const Angle&) = default;
};

struct Orientation {
  bool flip{};     // mirrored first: y becomes -y, so the grain line (along x) is unchanged
  Angle rotation;  // one of the shape's allowed rotations
  Angle tilt;      // a small angle added to the rotation
  friend constexpr auto operator<=>(const Orientation&, const Orientation&) = default;
};

// One of the eight exact symmetries of the lattice: an optional flip (y becomes -y) followed by quarter turns.
class Symmetry {
 public:
  constexpr Symmetry() = default;
  constexpr Symmetry(bool flip, int quarter_turns)
      : flip_{flip}, quarters_{static_cast<std::uint8_t>(quarter_turns & 3)} {}

  [[nodiscard]] constexpr bool flips() const { return flip_; }
  [[nodiscard]] constexpr int quarter_turns() const { return quarters_; }
  [[nodiscard]] constexpr int index() const { return (flip_ ? 4 : 0) + quarters_; }  // 0..7

  [[nodiscard]] constexpr Vec apply(Vec v) const {
    if (flip_) v.y = -v.y;
    switch (quarters_) {
      case 1: return {-v.y, v.x};
      case 2: return {-v.x, -v.y};
      case 3: return {v.y, -v.x};
      default: return v;
    }
  }
  [[nodiscard]] constexpr Symmetry inverse() const {
    return flip_ ? *this : Symmetry{false, -static_cast<int>(quarters_)};
  }
  // (a.after(b)).apply(v) == a.apply(b.apply(v))
  [[nodiscard]] constexpr Symmetry after(Symmetry first) const {
    const int q = flip_ ? quarters_ - first.quarters_ : quarters_ + first.quarters_;
    return {flip_ != first.flip_, q};
  }
  friend constexpr auto operator<=>(const Symmetry&, const Symmetry&) = default;

 private:
  bool flip_{};
  std::uint8_t quarters_{};
};
// The image of the polygon, in counter-clockwise order.  When the symmetry flips, the vertices are listed in reverse
// order, starting with the image of the first.
[[nodiscard]] Polygon transformed(const Polygon& polygon, Symmetry symmetry);

// An orientation split into p -> symmetry(turn(p)).  The turn is at most 45 degrees in size, and 0 when the orientation
// is exact.
struct SplitOrientation {
  Angle turn;
  Symmetry symmetry;
  friend constexpr auto operator<=>(const SplitOrientation&, const SplitOrientation&) = default;
};
[[nodiscard]] SplitOrientation split(const Orientation& orientation);

// The polygon rotated about its own origin, each vertex rounded to the nearest lattice point; unchanged for an angle of
// 0.
// Rounding can in principle make a thin spike touch itself.  The result is then not a Polygon, and make_marker rejects
// it.
[[nodiscard]] Polygon turned(const Polygon& polygon, Angle turn);

// Applies the whole orientation: flip, rotation and tilt.
[[nodiscard]] Polygon oriented(const Polygon& polygon, const Orientation& orientation);

}  // namespace selvage::geometry

// Basic types: also available in namespace selvage, so that every folder can use them unqualified.
namespace selvage {
using geometry::Angle;
using geometry::Orientation;
using geometry::Symmetry;
}  // namespace selvage
