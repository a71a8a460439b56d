// The pairs of outlines that sum_table adds: neighbours in markers, and random stars for sizes that do not occur in
// markers.
#pragma once

#include <vector>

#include "bench/sums/pair_sum.h"
#include "core/marker/marker.h"

namespace selvage::bench {

// Every pair of pieces that are neighbours in the first round of a compaction, in their relative orientation; equal
// pairs are listed once.
[[nodiscard]] std::vector<OutlinePair> neighbours_in(const Marker& marker);

// Pairs of random stars with this many vertices each, whose radii are uniform in [0.1, 0.5] of the extent.
[[nodiscard]] std::vector<OutlinePair> random_stars(std::size_t vertices, std::size_t pairs);

}  // namespace selvage::bench
