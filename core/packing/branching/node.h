// A node of the search: everything that is known of the layouts below it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/packing/branching/problem.h"
#include "core/packing/programs/dictionary.h"
#include "core/packing/programs/difference_bounds.h"

namespace selvage::packing::branching {

using cells::Arc;
using programs::Dictionary;
using programs::DifferenceBounds;
using programs::Reasons;

// One ring whose two bodies have their variants, and the arc of its wedges that is left.
struct RingState {
  std::uint32_t ring{};
  std::uint32_t first{}, second{};  // bodies
  Arc arc;
  Reasons why{};        // of the arc
  bool clear{};         // the pair's box lies outside the ring
  RealBox looked_at{};  // the pair's box when the arc was last trimmed
  // The rows of the convex hull of the arc's cells, as places in the relaxation's store; `none` before they are needed.
  static constexpr std::uint32_t kNone = UINT32_MAX;
  std::uint32_t hull_begin{kNone}, hull_end{};
};

struct Node {
  static constexpr std::uint32_t kUndecided = UINT32_MAX;

  DifferenceBounds x, y;
  std::vector<std::uint32_t> variant;  // by body
  std::vector<Reasons> why_variant;    // by body
  std::vector<RingState> rings;
  Dictionary program;
  double bound{};       // proved: no layout below this node is shorter
  Reasons why_bound{};  // of the bound
  std::size_t depth{};  // decisions since the subtree's first node
  std::size_t hulls{};  // the size of the store when the node and its siblings were complete
};

}  // namespace selvage::packing::branching
