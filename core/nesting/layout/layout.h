// A layout: where every piece of a set lies, and the length in which it should lie.
// Units: model units.
#pragma once

#include <cstdint>
#include <vector>

#include "core/marker/marker.h"
#include "core/nesting/layout/piece_set.h"

namespace selvage::nesting::layout {

struct Place {
  double x{}, y{};       // position of the outline's origin
  std::uint32_t turn{};  // index into the kind's `turned`
};

struct Layout {
  std::vector<Place> places;  // by piece
  double length{};            // the x that no piece should exceed
};

// The positions that the piece may take: within the strip up to the layout's length, in the room that its rules leave
// it, and near enough to the other pieces of its shade, where they lie now; those that lie beyond the length do not
// count.  Empty (high < low) when there is no such position.  This is the one place that says which positions are
// allowed: a layout that keeps the rules goes on keeping them as long as single pieces move to such positions.
[[nodiscard]] RealBox inner_fit(const PieceSet& set, const Layout& layout, std::size_t piece, std::uint32_t turn);
// The part of an inner fit that matches the piece to the cloth without changing to another repeat: on an axis on which
// its match point has to lie where a repeat begins, the one such position nearest to the given place; empty where there
// is none.  The whole fit for a piece that is not matched.
[[nodiscard]] RealBox matched_fit(const PieceSet& set, std::size_t piece, std::uint32_t turn, RealBox fit, double x,
                                  double y);
// The piece's box where it lies.
[[nodiscard]] RealBox placed_box(const PieceSet& set, const Layout& layout, std::size_t piece);
// False when two pieces that lie there are farther apart on an axis than their clearance and `reach`, going by their
// boxes alone.
[[nodiscard]] bool may_meet(const PieceSet& set, const Turned& first, const Place& at_first, const Turned& second,
                            const Place& at_second, double reach);
// True when every piece lies in the same orientation in both, no farther than `distance` from its other place.
[[nodiscard]] bool same_places(const Layout& a, const Layout& b, double distance);
// Puts the piece's middle there, or as near as its inner fit allows.
void centre_at(const PieceSet& set, Layout& layout, std::size_t piece, double x, double y);

// Changes the length.  Pieces whose middle lies beyond `split` move by the difference, and all stay within the strip;
// fixed pieces stay where they are.
void set_length(const PieceSet& set, Layout& layout, double length, double split);
// Makes the layout longer by a factor: the middles of all pieces but fixed ones move apart along the strip.
void stretch(const PieceSet& set, Layout& layout, double factor);

// The marker with every piece placed as in the layout, rounded to the lattice: first the pieces that `start` had
// placed, then those it had not.  Fixed pieces stay exactly where they were. REQUIRES: the set is that of `start`.
[[nodiscard]] Marker to_marker(const PieceSet& set, const Layout& layout, const Marker& start);
// The layout of a marker that to_marker returned, or that a motion made of one; tilts are not looked at.
[[nodiscard]] Layout to_layout(const PieceSet& set, const Marker& marker);

}  // namespace selvage::nesting::layout
