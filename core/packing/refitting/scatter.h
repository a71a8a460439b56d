// Pieces put one after another where they fit, each at the free position nearest to a random point: a quick attempt
// before all of them are fitted at once (core/packing/contain.h).
#pragma once

#include <cstddef>
#include <optional>
#include <random>

#include "core/marker/marker.h"
#include "core/scene/run.h"

namespace selvage::packing::refitting {

struct Scattered {
  std::optional<Marker> layout{};  // with all pieces placed; nothing when one of them found no room
  std::size_t placed{};            // pieces that found room
};
// Places the unplaced pieces of a marker, the largest first, none of them beyond x = `end`.  With `turns`, they may
// take other orientations that their shapes allow.
// REQUIRES: the placed pieces are valid; the unplaced ones have no locks of x and y and no group.
[[nodiscard]] Scattered scattered(const Marker& marker, Coord end, bool turns, std::mt19937_64& random,
                                  const scene::Run& run);

}  // namespace selvage::packing::refitting
