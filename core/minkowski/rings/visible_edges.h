// The boundary of the union of star-shaped sums: the parts of their edges that lie inside no other one.  Each of them
// is a ring of edges. Units: lattice units.
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/minkowski/convolution/star_sum.h"

namespace selvage::minkowski::rings {

// Edges within this many lattice units of another ring's boundary are visible, because rounded end points do not tell
// on which side of it they are.
inline constexpr double kHidden = 1.0;

// Leaves out rings that repeat an earlier one, if there are many: the teeth of two regular combs, n each, have n * n
// sums, of which only 2 n - 1 differ.
void leave_out_repeats(std::vector<convolution::StarSum>& rings);

// The visible parts of all edges, those of a ring one after another.  `boxes`: of the rings.  Nothing when cancelled,
// which is checked once for each ring.
[[nodiscard]] std::optional<std::vector<convolution::SumEdge>> visible_edges(
    std::span<const convolution::StarSum> rings, std::span<const Box> boxes, const std::stop_token& stop);

}  // namespace selvage::minkowski::rings
