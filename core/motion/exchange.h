// Exchanges: what no motion of all pieces at once can reach.  Two pieces change places, or one turns to another of its
// rotations; what overlaps then is separated, and the marker compacted: a step of a local search over layouts, of the
// kind that [Li94 10] hands to a data base of layouts.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <stop_token>

#include "core/motion/compact.h"

namespace selvage {

struct Exchanged {
  std::optional<Marker> marker;  // valid; nothing when the pieces could not be parted within the growth allowed
  int programs{};                // linear programs solved
};

// A random exchange among the pieces that are free on both axes and of no group: mostly of two that differ little in
// size and lie near each other.  The answer may be longer than `start`, by little.  What is drawn depends on `random`
// and the marker alone.  REQUIRES: start is valid.
[[nodiscard]] Exchanged exchange(const Marker& start, const CompactionSettings& settings, std::mt19937& random,
                                 SumCache& sums, const std::stop_token& stop);

}  // namespace selvage
