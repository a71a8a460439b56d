// Cloth's rules: where on the strip a piece may lie, besides keeping clear of other pieces.  What they demand of a
// piece is defined here, and nowhere else: its room, which is the strip's unless it has rules of its own, and the
// pieces that have to lie near it along x.  Units: lattice units.
// A zone, a part of the cloth that no piece may cover, or only some, is listed among the pieces and handled as a locked
// one.  It differs from a locked piece in four ways: it may lie anywhere, also beyond the strip; it keeps no distance
// from pieces, and allows no overlap; zones may overlap each other; and it counts neither as a piece nor in length and
// utilisation.  The cloth of a zone may have a quality class, as parts of a sheet have in packingsolver
// (github.com/fontanf/packingsolver): pieces that accept the class lie there as on any other cloth.  A part of a piece
// may accept less than the rest of it; a zone that is too bad only for the part meets that part and not the whole
// piece.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/lattice.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"

namespace selvage::marker {

struct Marker;
struct Strip;

// The pattern of the cloth: stripes repeat on one axis, a plaid on both.
struct Repeat {
  Coord along{}, across{};  // the length of a repeat in x and in y; 0: the pattern does not change along that axis
  Vec phase{};              // a point at which a repeat begins

  [[nodiscard]] bool any() const { return along > 0 || across > 0; }
  friend bool operator==(const Repeat&, const Repeat&) = default;
};

// How a piece lies on cloth with a nap, seen along the strip: the way in which the x axis of its shape points.
enum class Nap { kUp, kDown };  // towards larger x, and towards smaller x

// A class of the cloth's quality: 0 is the best, that of all cloth outside of zones, and a larger number is worse.
using Quality = std::int32_t;
inline constexpr Quality kWorstQuality = 99;

// The part of a piece that accepts less than the rest of it, such as the one that is seen when the garment is worn.
struct Part {
  Polygon outline;    // within that of the shape, in its coordinates
  Quality quality{};  // the worst class that the part accepts: less than that of the piece
  friend bool operator==(const Part&, const Part&) = default;
};

// The edge of folded or tubular cloth on which a piece lies.
enum class FoldEdge { kLower, kUpper };

// The rules of one piece.  Where one is absent, the strip's own applies, if it has one.
struct Rules {
  std::optional<Coord> below{}, above{};  // selvedges of its own: its distances from the strip's long edges
  std::optional<Coord> from{}, to{};      // a band across the cloth: it lies between these two x
  bool on_fold{};                         // a side of it lies on an edge of the strip where the cloth is folded
  std::optional<Vec> match{};             // a point of the shape: it lies where a repeat of the cloth begins or,
  std::string match_set{};                // with a set, whole repeats away from those of its other pieces; empty: none
  std::optional<Vec> phase{};             // where repeats begin for it, in place of the cloth's; none: as on the cloth
  std::string shade{};                    // pieces of one shade lie within Marker::shade of each other; empty: no shade
  std::optional<Nap> nap{};               // it lies this way
  bool zone{};  // it is no piece of a garment but a part of the cloth that no piece may cover, such as a flaw or a hole
  std::optional<Quality> quality{};  // of a piece: the worst class that it accepts; none: 0.  Of a zone: the class of
                                     // its cloth, at least 1; none: one that no piece accepts
  std::optional<Part> part{};        // the part that accepts less; none: all of the piece accepts the same

  // True when its match point lies where a repeat of the cloth begins, whatever other pieces do.
  [[nodiscard]] bool matched_to_cloth() const { return match && match_set.empty(); }
  // True when some rule concerns this piece alone, so that its room is not the strip's.
  [[nodiscard]] bool own_room() const { return below || above || from || to || on_fold || matched_to_cloth() || zone; }
  friend bool operator==(const Rules&, const Rules&) = default;
};

// True when a piece in this orientation lies as its rules ask: turned by less than a quarter from `up` or `down`.
// Tilts, which are small, make no difference.
[[nodiscard]] bool keeps_nap(const Rules& rules, const Orientation& orientation);

// True when the two may lie over each other whatever their outlines: two zones, or a zone and a piece that accepts the
// quality of its cloth.
[[nodiscard]] bool may_share_cloth(const Rules& p, const Rules& q);
// True when the piece accepts the quality of the zone's cloth but for its part, so that the part is all of the piece
// that may not lie over the zone.
[[nodiscard]] bool only_part_meets(const Rules& piece, const Rules& zone);

// True when a side of the outline lies along that end of its box, so that it can lie on a fold.
[[nodiscard]] bool has_side_at(std::span<const Vec> outline, FoldEdge edge);
// The edge that a piece with this turned outline lies on where it has to lie on the fold: the lower one, but the upper
// edge of a tube when only its highest side is straight.
[[nodiscard]] FoldEdge fold_edge(const Rules& rules, std::span<const Vec> outline, const Strip& strip);
// True unless the piece has to lie on the fold, and no side of its turned outline can.
[[nodiscard]] bool has_side_for_fold(const Rules& rules, std::span<const Vec> outline, const Strip& strip);

// The cloth's pattern as the piece is matched to it.
[[nodiscard]] Repeat repeat_for(const Rules& rules, const Strip& strip);

// The room of a piece: the box in which its own box may lie when the strip ends at x = `end`.  `height`: of the piece's
// box, which fills the room across when it lies on the fold, at the edge `fold`.  The room of a zone is the whole
// plane.
[[nodiscard]] Box room_for(const Rules& rules, Coord height, FoldEdge fold, const Strip& strip, Coord end);

// The part of a room in which a piece that is matched to the cloth may lie without changing to another repeat: on an
// axis on which the pattern repeats, its only position is the one nearest to where it lies now.  `box` and `point`:
// where its box and its match point lie now.  Empty (high < low) on an axis on which the room has no position for it.
[[nodiscard]] Box matched_room(const Box& room, const Box& box, Vec point, const Repeat& repeat);

// What is left of a way from one match point to another without whole repeats of the cloth: on each axis from minus
// half a repeat to half a repeat; 0 on an axis on which the pattern does not change.
[[nodiscard]] Vec off_repeat(Vec way, const Repeat& repeat);

// The pieces of one match set: the ways between their match points are whole repeats of the cloth.  The set itself may
// lie anywhere in the pattern.
using MatchSet = std::vector<std::uint32_t>;  // at least two, ascending

// The pieces of one shade: from the left end of the leftmost to the right end of the rightmost is at most `length`.
struct Shade {
  std::vector<std::uint32_t> pieces;  // at least two, ascending
  Coord length{};
};

// The rules of all pieces of a marker.
struct Rooms {
  std::vector<Rules> rules;  // by piece
  std::vector<Shade> shades;
  std::vector<MatchSet> match_sets;
  Repeat repeat;  // of the cloth
};
// Nothing when no placed piece has a rule.
[[nodiscard]] std::optional<Rooms> rooms_of(const Marker& marker);

}  // namespace selvage::marker
