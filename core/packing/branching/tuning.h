// The tuning constants of the exact search.  No answer becomes wrong with other values: a search only takes longer.
// docs/measurements/searches/packing.md has the figures behind them.
#pragma once

#include <cstdint>

namespace selvage::packing::branching {

struct BranchTuning {
  double shrink{0.05};          // part of a pair's box by which it must shrink before its ring is looked at again
  int propagations{6};          // rounds of looks at a node
  int programs{40};             // times that rows are added to a node's program
  double tolerance{2e-8};       // depth at which a solution counts as inside a ring, in widths of the room
  double violated{1e-8};        // by which a row must be violated before it enters, in widths of the room
  double slack{0.02};           // rows with more room than this, in widths, are dropped from the programs of children
  double contact{8};            // pairs this near to contact, in lattice units, are split when a leaf cannot be placed
  std::uint32_t few_wedges{4};  // an arc of at most this many wedges is split into single wedges
  friend bool operator==(const BranchTuning&, const BranchTuning&) = default;
};

struct SearchTuning {
  BranchTuning branch{};
  std::size_t subtrees{32};  // the search near the root is best first until there are this many open nodes
  std::size_t at_once{8};    // subtrees searched in one round; threads share them
  std::uint64_t burst{256};  // nodes of a subtree in one round
  friend bool operator==(const SearchTuning&, const SearchTuning&) = default;
};

}  // namespace selvage::packing::branching
