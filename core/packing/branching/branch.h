// Branching: from a node whose solution still overlaps to children that cover all its layouts.
//
// First the orientations are decided, of large bodies first.  Then the ring in which the solution lies deepest, weighed
// by the ring's size, is split: a whole ring into about four arcs that meet at the ray through the solution, an arc
// into two, a short arc into its wedges.
#pragma once

#include <optional>
#include <vector>

#include "core/packing/branching/relaxation.h"

namespace selvage::packing::branching {

// The settled children, the cheapest last; none when no layout is left.  Nothing when the solution is at most `depth`
// inside every ring that can be split: with the relaxation's tolerance, when the node is a leaf.
[[nodiscard]] std::optional<std::vector<Node>> children(Relaxation& relaxation, const Problem& problem,
                                                        const Node& node, const BranchTuning& tuning, double depth);

}  // namespace selvage::packing::branching
