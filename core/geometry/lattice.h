// The integer lattice that all geometry uses, and the mapping from a marker's decimal numbers to it.
//
// A coordinate is a whole number of lattice units.  A marker's Resolution gives the length of a lattice unit as a power
// of ten of the marker's own unit, so decimal input is represented exactly.  Extents stay below 2^40 units, so
// Minkowski sums stay below 2^41 and every cross product below 2^86, which is exact in 128 bits.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <span>

namespace selvage::geometry {

using Coord = std::int64_t;           // lattice units
__extension__ using Wide = __int128;  // products of two coordinates

inline constexpr Coord kLatticeLimit = Coord{1} << 40;  // extents of a marker stay below this

// A point or a vector, in lattice units.
struct Vec {
  Coord x{}, y{};
  friend constexpr auto operator<=>(const Vec&, const Vec&) = default;
  friend constexpr Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec operator-(Vec a) { return {-a.x, -a.y}; }
};

// Twice the signed area of the triangle (0, a, b): positive when b lies to the left of a.
[[nodiscard]] constexpr Wide cross(Vec a, Vec b) {
  return static_cast<Wide>(a.x) * b.y - static_cast<Wide>(a.y) * b.x;
}
[[nodiscard]] constexpr Wide dot(Vec a, Vec b) {
  return static_cast<Wide>(a.x) * b.x + static_cast<Wide>(a.y) * b.y;
}
// +1 when c lies to the left of the line from a to b, -1 to the right, 0 on it.  Exact.
[[nodiscard]] constexpr int side_of(Vec a, Vec b, Vec c) {
  const Wide w = cross(b - a, c - a);
  return (w > 0) - (w < 0);
}

// A closed axis-parallel box.
struct Box {
  Vec low, high;
  friend constexpr bool operator==(const Box&, const Box&) = default;
  [[nodiscard]] constexpr Coord width() const { return high.x - low.x; }
  [[nodiscard]] constexpr Coord height() const { return high.y - low.y; }
  [[nodiscard]] constexpr Box moved(Vec by) const { return {low + by, high + by}; }
  [[nodiscard]] constexpr Box grown(Coord by) const { return {{low.x - by, low.y - by}, {high.x + by, high.y + by}}; }
  // True when the interiors intersect; boxes that only touch do not overlap.
  [[nodiscard]] constexpr bool overlaps(const Box& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
  }
  [[nodiscard]] constexpr bool contains(const Box& other) const {
    return other.low.x >= low.x && other.low.y >= low.y && other.high.x <= high.x && other.high.y <= high.y;
  }
  [[nodiscard]] constexpr bool touches(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
  }
};
// The smallest box that contains both.
[[nodiscard]] constexpr Box united(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}
// REQUIRES: at least one point.
[[nodiscard]] Box box_of(std::span<const Vec> points);

// True when the closed segments from a to b and from c to d share a point.  Exact.
[[nodiscard]] bool segments_meet(Vec a, Vec b, Vec c, Vec d);

// The length of one lattice unit: 10^exponent of the marker's unit.
struct Resolution {
  int exponent{};
  friend constexpr auto operator<=>(const Resolution&, const Resolution&) = default;
};
inline constexpr int kFinestExponent = -22;  // 10^22 is the largest power of ten a double holds exactly
inline constexpr int kCoarsestExponent = 6;

// The number of decimal places in the shortest decimal text of `value`: 12.5 has 1, 100 has 0, 1e-7 has 7.
[[nodiscard]] int decimals_of(double value);

// The default resolution.  `decimals` is the largest number of decimal places in the input; `extent` is the largest
// absolute coordinate and `width` is the strip's width, both in the marker's unit.
// The resolution represents all input exactly where the lattice limit allows it.  It is finer still, so that the strip
// is at least 2^28 units wide, or as fine as possible where it cannot be exact, both only as far as
// coordinates may still grow to kHeadroom times the extent: markers become longer when pieces are separated or added.
[[nodiscard]] Resolution choose_resolution(int decimals, double extent, double width);

inline constexpr double kHeadroom = 8;

// The nearest lattice coordinate.  Exact when `value` has no more decimal places than the resolution.
// REQUIRES: fits_lattice(value, resolution).
[[nodiscard]] Coord to_lattice(double value, Resolution resolution);
[[nodiscard]] bool fits_lattice(double value, Resolution resolution);
// The double whose shortest text is exactly the coordinate as a decimal.
[[nodiscard]] double to_decimal(Coord coord, Resolution resolution);

}  // namespace selvage::geometry

// Basic types: also available in namespace selvage, so that every folder can use them unqualified.
namespace selvage {
using geometry::Box;
using geometry::Coord;
using geometry::kLatticeLimit;
using geometry::Resolution;
using geometry::Vec;
using geometry::Wide;
}  // namespace selvage
