// Branching: from a node whose solution still overlaps to children that cover all its layouts.
//
// First the orientations are decided, of large bodies first.  Then a ring in which the solution lies is split, chosen
// by the depth there, by the ring's size, which counts for more where any layout will do, and by how often looks at it
// have found a conflict [BHLS04]: a whole ring into about four arcs that meet at the ray through the solution, an arc
// into two, a short arc into its wedges.
#pragma once

#include <vector>

#include "core/packing/branching/relaxation.h"

namespace selvage::packing::branching {

struct Children {
  bool leaf{};              // the solution is at most `depth` inside every ring that can be split
  std::vector<Node> nodes;  // settled, the most promising last
  Reasons conflict{};       // why these are all: the decisions from which it follows that there are no others
};

// The children of a node.  As soon as one of them has no layout for reasons that its siblings share, there are none.
// With the relaxation's tolerance as `depth`, `leaf` means that the node is one.
[[nodiscard]] Children children(Relaxation& relaxation, const Problem& problem, const Node& node,
                                const BranchTuning& tuning, double depth);

}  // namespace selvage::packing::branching
