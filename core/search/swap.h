// Swaps reach layouts that no motion of all pieces at once can reach: two pieces change places, or one turns to another
// of its rotations, or one that is matched to the cloth moves by a repeat of the pattern; then overlapping pieces are
// separated and the marker is compacted.  This is one step of a local search over layouts, for which [Li94 10] suggests
// a database of layouts.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <span>

#include "core/motion/compaction/compact.h"
#include "core/search/tuning.h"

namespace selvage::search {

// A swap that has been drawn: the pieces are at their new positions, where they usually overlap others.
struct DrawnSwap {
  Marker marker;
  Coord length{};       // of the marker before the swap
  bool even_if_deep{};  // it is tried even if the pieces overlap deeply
};
// A random swap among the pieces that are free on both axes and in no group, mostly of two that have similar sizes and
// lie near each other, and mostly of a piece of `critical`, if that names any.  It depends only on `random`, the marker
// and the critical pieces.  None when no piece has a partner or another rotation.
[[nodiscard]] std::optional<DrawnSwap> draw_swap(const Marker& start, std::mt19937& random,
                                                 std::span<const PieceId> critical = {}, const SwapTuning& tuning = {});

struct SwapOutcome {
  std::optional<Marker> marker;  // valid; none when the pieces overlap too deeply, or could not be separated within the
                                 // allowed growth
  int programs{};                // linear programs solved
};
// Separates the overlapping pieces and compacts, unless they overlap by more than SwapTuning::deepest and the swap was
// not drawn to be tried even so.  The answer may be a little longer than the marker was before.
// REQUIRES: the marker was valid before.
[[nodiscard]] SwapOutcome complete_swap(const DrawnSwap& drawn, const motion::compaction::CompactionSettings& settings,
                                        const scene::Run& run, const SwapTuning& tuning = {});

}  // namespace selvage::search
