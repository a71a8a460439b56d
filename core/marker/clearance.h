// The proof of every answer: pieces may touch, but they never overlap by more than their allowance, never come closer
// than their spacing, never leave the strip or enter its margins, and keep cloth's rules (rules.h), its zones among
// them.  The proof is decided in integers, and only here: all code that moves pieces calls one of these functions
// before it answers.
//
// Pairs of pieces are found by a sweep over their boxes (placed_pieces.h); a single piece is compared with the boxes of
// all others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/executor.h"
#include "core/marker/placed_pieces.h"

namespace selvage::marker {

// True when the two overlap, or are closer than the spacing.  With a negative spacing, when no translation of at most
// its magnitude is found that separates them (core/geometry/separating_translation.h).
[[nodiscard]] bool collide(const geometry::PlacedPolygon& p, const geometry::PlacedPolygon& q, Coord spacing);
// The same for two pieces and the spacing between them.
[[nodiscard]] bool conflict(const PlacedPieces& pieces, PiecePair pair);

// Heaps of thousands of pieces have more pairs that collide than there is room for: no more than this many are listed.
inline constexpr std::size_t kMostConflicts = 1'000'000;

// All pairs that collide, sorted; when there are more than kMostConflicts, that many of them.  When cancelled, only
// some: a caller that may be cancelled looks at the token afterwards.
[[nodiscard]] std::vector<PiecePair> conflicts(const PlacedPieces& pieces, const Executor& executor = serial(),
                                               const std::stop_token& stop = {});
// True when some pair collides.
[[nodiscard]] bool any_conflict(const PlacedPieces& pieces);

// True when `polygon`, in place of the piece, collides with no other piece.  `part`: the piece's part (rules.h), turned
// like the polygon; empty when it has none.
[[nodiscard]] bool is_clear(const PlacedPieces& pieces, std::uint32_t piece, const geometry::PlacedPolygon& polygon,
                            std::span<const Vec> part = {});
// True when the moving pieces, all displaced by the same vector, collide with none of the others.
[[nodiscard]] bool are_clear(const PlacedPieces& pieces, const std::vector<bool>& moving, Vec by);
// True when none of the changed pieces collides with any piece.
[[nodiscard]] bool are_clear(const PlacedPieces& pieces, std::span<const std::uint32_t> changed);

// The largest distance by which a piece leaves its room; 0 or less when it does not.
[[nodiscard]] Coord protrusion_of(const PlacedPieces& pieces, std::size_t piece, const Strip& strip);
// True when the rules that concern several pieces are kept: pieces of each shade are as near to each other as they have
// to be, and pieces of each match set are in phase.
[[nodiscard]] bool keep_joint_rules(const PlacedPieces& pieces);
// True when no piece leaves its room, and joint rules are kept.
[[nodiscard]] bool are_inside(const PlacedPieces& pieces, const Strip& strip);

// True when another piece, placed or not, belongs to the same shade; a piece that is alone in its shade lies within any
// length.
[[nodiscard]] bool shares_shade(const Marker& marker, const Piece& piece);
// True when a piece, as it is turned, is not too wide for the room that its rules leave it, nor too long for its band
// or for its shade, lies with its nap, can lie on the fold where it has to, and has a position in its room that is
// matched to the cloth where it has to be.  Where it lies now does not matter.
[[nodiscard]] bool may_lie(const Marker& marker, const Piece& piece);

// The whole proof: every piece is inside, and no two collide.
[[nodiscard]] bool all_clear(const PlacedPieces& pieces, const Strip& strip);

}  // namespace selvage::marker
