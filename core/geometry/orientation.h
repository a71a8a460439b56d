// How a piece lies: flip, then a rotation, then a tilt [Li94 1.1.4; design: numbers].
//
// Flips and multiples of 90 degrees map the lattice onto itself: they form the eight Symmetries and are exact.  What is
// left of the angle is a turn of less than 90 degrees; a turned shape is rounded to the lattice once, and from then on
// the rounded shape is the piece.
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
  bool flip{};     // mirrored first: y becomes -y, so the grain line (along x) stays
  Angle rotation;  // one of the shape's allowed rotations
  Angle tilt;      // small, on top of the rotation
  friend constexpr auto operator<=>(const Orientation&, const Orientation&) = default;
};

// One of the eight exact symmetries of the lattice: a flip (y becomes -y) and then quarter turns.
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
// The image, counter-clockwise again when the symmetry flips (its vertices then run backwards from the first).
[[nodiscard]] Polygon transformed(const Polygon& polygon, Symmetry symmetry);

// An orientation taken apart: p -> symmetry(turn(p)), turn less than 90 degrees, 0 when the orientation is exact.
struct SplitOrientation {
  Angle turn;
  Symmetry symmetry;
  friend constexpr auto operator<=>(const SplitOrientation&, const SplitOrientation&) = default;
};
[[nodiscard]] SplitOrientation split(const Orientation& orientation);

// The polygon turned about its own origin, each vertex rounded to the nearest lattice point; the same polygon for 0.
// Rounding can in principle make a needle touch itself: then what comes back is not a Polygon (make_marker refuses it).
[[nodiscard]] Polygon turned(const Polygon& polygon, Angle turn);

// The whole: flip, rotation, tilt.
[[nodiscard]] Polygon oriented(const Polygon& polygon, const Orientation& orientation);

}  // namespace selvage::geometry

// Vocabulary: named in selvage itself as well, so that every room may use it unqualified.
namespace selvage {
using geometry::Angle;
using geometry::Orientation;
using geometry::Symmetry;
}  // namespace selvage
