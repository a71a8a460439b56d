// Exchanges: what no motion of all pieces at once can reach.  Two pieces change places, or one turns to another of its
// rotations; what overlaps then is separated, and the marker compacted: a step of a local search over layouts, of the
// kind that [Li94 10] hands to a data base of layouts.
#pragma once

#include <cstdint>
#include <optional>
#include <random>

#include "core/motion/compaction/compact.h"
#include "core/search/tuning.h"

namespace selvage::search {

// An exchange that has been drawn: the pieces are where they are to be, and overlap as a rule.
struct DrawnExchange {
  Marker marker;
  Coord length{};  // of the marker before
};
// A random exchange among the pieces that are free on both axes and of no group: mostly of two that differ little in
// size and lie near each other.  What is drawn depends on `random` and the marker alone; nothing when no piece has a
// partner or another rotation.
[[nodiscard]] std::optional<DrawnExchange> draw_exchange(const Marker& start, std::mt19937& random,
                                                         const SwapTuning& tuning = {});

struct Exchanged {
  std::optional<Marker> marker;  // valid; nothing when the pieces could not be parted within the growth allowed
  int programs{};                // linear programs solved
};
// Parts what overlaps and compacts.  The answer may be longer than the marker was before, by little.
// REQUIRES: the marker was valid before.
[[nodiscard]] Exchanged exchange(const DrawnExchange& drawn, const motion::compaction::CompactionSettings& settings,
                                 const scene::Run& run, const SwapTuning& tuning = {});

}  // namespace selvage::search
