// The nearest free position inside one window of positions, by branch and bound over the window's parts, with the
// borders of forbidden positions that enter each part.
#pragma once

#include <optional>
#include <stop_token>

#include "core/motion/placing/surroundings.h"
#include "core/motion/placing/tuning.h"

namespace selvage::motion::placing {

// The free position in `window` that is nearest to `wanted`, or `best` where none is nearer than that; proved in
// integers, and the nearest but for rounding to the lattice (place.h); nothing when cancelled.  `window` lies inside
// the strip; `origin` is a position in it, near which real coordinates are exact enough.
[[nodiscard]] std::optional<Vec> nearest_in_window(const scene::Scene& scene, const Body& body, const Box& window,
                                                   Vec wanted, Vec origin, std::optional<Vec> best,
                                                   const PlaceTuning& tuning, const std::stop_token& stop);

}  // namespace selvage::motion::placing
