// The search: best first near the root, then rounds of depth-first bursts in the most promising subtrees.
//
// Where any layout will do, each round begins with the conflicts that all subtrees have had so far.
// The schedule of rounds does not depend on the number of threads: a round takes the same subtrees, explores each of
// them with the ceiling of the round's start, and combines the outcomes in their order.  Answers and counts do not
// depend on it either. A bound is proved at any time: the least of the open nodes' bounds and of the ceilings at which
// others were closed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

#include "core/base/executor.h"
#include "core/packing/branching/subtree.h"
#include "core/packing/branching/tuning.h"

namespace selvage::packing::branching {

struct WorkLimits {
  std::uint64_t nodes{UINT64_MAX}, pivots{UINT64_MAX};
  friend bool operator==(const WorkLimits&, const WorkLimits&) = default;
};

enum class SearchEnd { kExhausted, kAnswered, kWorkLimit, kCancelled };

struct SearchOutcome {
  SearchEnd end{};
  double bound{};    // proved: no layout up to the ceiling is shorter; above the ceiling when there is none
  bool undecided{};  // some leaf could not be placed: that there is no layout is not proved
  Work work;
};

struct SearchCalls {
  PlaceLeaf place_leaf;
  std::function<void(const Leaf&)> on_leaf;  // of every leaf that is placed
  std::function<void(double bound, const Work&)> on_round = [](double, const Work&) {};
  // Called after every round without a layout: one that is found in another way, placed, ends the search.  Adds its own
  // work.  Only where any layout will do.
  std::function<std::optional<Leaf>(Work&)> guess{};
  std::stop_token stop{};
  const Executor* executor = &serial();
};

// Searches the layouts up to the ceiling.  Where the length is minimised, until none is shorter than the shortest one
// found by more than the gap; otherwise until one is found.  With a vicinity, layouts outside of it do not count.
[[nodiscard]] SearchOutcome search(const Problem& problem, double ceiling, double gap, const WorkLimits& limits,
                                   const SearchTuning& tuning, const SearchCalls& calls,
                                   const Vicinity* vicinity = nullptr);

}  // namespace selvage::packing::branching
