// The pairs of outlines that sum_table adds: neighbours in markers, and random stars for sizes that markers do not
// have.
#pragma once

#include <vector>

#include "bench/sums/pair_sum.h"
#include "core/marker/marker.h"

namespace selvage::bench {

// Of every two neighbours in the sense of a compaction's first round, in their relative orientation, taken once however
// often it occurs.
[[nodiscard]] std::vector<OutlinePair> neighbours_in(const Marker& marker);

// Pairs of random stars with this many vertices each, their centres' distances even in [0.1, 0.5] of the extent.
[[nodiscard]] std::vector<OutlinePair> random_stars(std::size_t vertices, std::size_t pairs);

}  // namespace selvage::bench
