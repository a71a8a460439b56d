// The boundary of the union of star-shaped sums: the parts of their edges that lie inside no other sum.  The edges of a
// star-shaped sum form a ring around its centre, so it is called a ring here.
//
// Units: lattice units.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/minkowski/convolution/star_sum.h"

namespace selvage::minkowski::rings {

// Edges within this many lattice units of another ring's boundary are visible, because rounded end points do not tell
// on which side of it they are.
inline constexpr double kHidden = 1.0;

// Leaves out rings that repeat an earlier one, if there are many: the teeth of two regular combs, n each, have n * n
// sums, of which only 2 n - 1 differ.
void leave_out_repeats(std::vector<convolution::StarSum>& rings);

// The visible parts of all edges, those of a ring one after another.  `boxes`: of the rings.  Nothing when
// `stopped`, which is asked once for each ring unless it is empty.
[[nodiscard]] std::optional<std::vector<convolution::SumEdge>> visible_edges(
    std::span<const convolution::StarSum> rings, std::span<const Box> boxes, const std::function<bool()>& stopped);

}  // namespace selvage::minkowski::rings
