// Lines across a container, and how much of each line the pieces cover.  The chords of pieces that do not overlap lie
// side by side on a line, so together they are no longer than the part of it that is free: the argument of compulsory
// parts in cumulative scheduling [Lah82].  It shows that pieces do not fit together even where any two of them do.
//
// Lines cross an axis; `u` is a coordinate along it.  They lie half a unit away from lattice points, where no piece on
// the lattice has a corner.  Outward rounding: chords are sums of crossings of edges, computed in doubles from
// coordinates below 2^42, each wrong by less than kCrossingError.  kChordSlack is more than the errors of all crossings
// of one piece, which has at most geometry::kMaxVertices.
// Units: lattice units.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/polygon.h"

namespace selvage::packing::lines {

inline constexpr double kCrossingError = 1.0 / 256;
inline constexpr double kChordSlack = 16;
static_assert(kChordSlack > kCrossingError * geometry::kMaxVertices);

enum class Crossing { kX, kY };  // the axis that the lines cross

// The least chord of a figure on each part of the axis: part k holds all u from k * part to (k + 1) * part, counted
// from the figure's low end.  On a part that the figure leaves, there is none.
struct Chords {
  std::vector<double> least;
  double most{};  // of these
};

struct Lines {
  double low{};              // where they begin, across the axis
  std::vector<double> at;    // where they cross the axis, ascending
  std::vector<double> room;  // at most this much of each line is free
  double part{};             // of all chords
  // By figure and variant; after the variants, the least in any of them.
  std::vector<std::vector<Chords>> chords;
};

// The chords of polygons that keep together; where they overlap each other, those of one count.
[[nodiscard]] Chords chords_of(std::span<const Polygon> figure, Crossing crossing, double part);

// How much of each line at `at` is free, from `low` to `high`, beside polygons, which may overlap each other.
[[nodiscard]] std::vector<double> free_lengths(std::span<const double> at, double low, double high,
                                               std::span<const Polygon> polygons, Crossing crossing);

// Lines across the whole room, with the chords of figures that have to lie in it, by figure and variant.  Nothing may
// overlap the obstacles or another figure.  REQUIRES: every figure has a variant.
[[nodiscard]] Lines lines_across(Crossing crossing, const Box& room, std::span<const Polygon> obstacles,
                                 std::span<const std::vector<std::vector<Polygon>>> figures);

}  // namespace selvage::packing::lines
