// Lines across a container, and how much of each the pieces cover.  Pieces that do not overlap have their chords on a
// line side by side, so these are together no longer than what is free of it: the argument of compulsory
// parts in cumulative scheduling [Lah82].  It tells that pieces do not fit together although each two of them do.
//
// Lines cross an axis; `u` is a coordinate along it.  They lie half a unit beside lattice points, where no piece on the
// lattice has a corner.  Outward rounding: chords are sums of crossings of edges, computed in doubles from coordinates
// below 2^42, each wrong by less than 2^-8 units.  kChordSlack is more than the errors of 2000 of them.
// Units: lattice units.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/polygon.h"

namespace selvage::packing::lines {

inline constexpr double kChordSlack = 16;

enum class Crossing { kX, kY };  // the axis that the lines cross

// The least chord of a figure on each part of the axis: part k holds all u from k * part to (k + 1) * part, counted
// from the figure's low end.  On a part that the figure leaves, there is none.
struct Chords {
  std::vector<double> least;
  double most{};  // of these
};

struct Lines {
  double low{};              // where they begin, across the axis
  std::vector<double> at;    // ascending
  std::vector<double> room;  // no more than this is free of each
  double part{};             // of all chords
  // By figure and variant; after the variants, the least in any of them.
  std::vector<std::vector<Chords>> chords;
};

// The chords of polygons that keep together; where they overlap each other, those of one count.
[[nodiscard]] Chords chords_of(std::span<const Polygon> figure, Crossing crossing, double part);

// What is free of lines at `at`, from `low` to `high`, beside polygons, which may overlap each other.
[[nodiscard]] std::vector<double> free_lengths(std::span<const double> at, double low, double high,
                                               std::span<const Polygon> polygons, Crossing crossing);

// Lines across the whole room, with the chords of figures that have to lie in it, by figure and variant.  Nothing may
// overlap the obstacles or another figure.  REQUIRES: every figure has a variant.
[[nodiscard]] Lines lines_across(Crossing crossing, const Box& room, std::span<const Polygon> obstacles,
                                 std::span<const std::vector<std::vector<Polygon>>> figures);

}  // namespace selvage::packing::lines
