// Which repeats of the cloth's pattern are tried for a piece that is matched to it (core/marker/rules.h).
// Units: lattice units.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/lattice.h"

namespace selvage::motion::placing {

// How near a piece at `at` can come to the wanted position without changing to another repeat; it moves freely on the
// axes on which nothing repeats, whose repeat is 0.
[[nodiscard]] double least_distance(Vec at, Vec wanted, Vec repeat);

// Up to `count` displacements by whole repeats, first those that bring a piece nearest to the wanted position.
// REQUIRES: a repeat on some axis.
[[nodiscard]] std::vector<Vec> jumps_towards(Vec from, Vec wanted, Vec repeat, std::size_t count);

}  // namespace selvage::motion::placing
