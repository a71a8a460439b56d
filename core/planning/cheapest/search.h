// The search for the cheapest cutting at given lengths.
//
// Method.  The relaxation gives a bound and says what every candidate would add to it.  Simulated annealing
// (annealing.h) finds a cutting, and integer programs over its markers and their neighbours (one bundle more, fewer, or
// of another size) improve it.  Then the bound is raised: sets of few markers are listed (program/few_markers.h), and
// all other cuttings pay for more markers.  Finally, an integer program over all candidates that could still be better
// closes the gap as far as its limit of nodes allows.
//
// Laws.  (1) The answer delivers what is ordered, checked in integers.  (2) bound <= cost; when they are equal, no
// cutting of any ratio is cheaper at these lengths.  (3) The answer costs no more than `start`.  (4) Deterministic.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/planning/cheapest/lengths.h"
#include "core/planning/cheapest/tuning.h"

namespace selvage::planning::cheapest {

using program::Cutting;

struct SearchSettings {
  bool thorough{true};  // false: the bound stays the relaxation's, and nothing is done to close the gap
  double gap{0.01};     // relative: the search ends when cost - bound is at most this part of the cost
  std::size_t most_listed{kMostListed};
  SearchTuning tuning{};
};

struct SearchResult {
  std::optional<Cutting> cutting;  // none: no cutting delivers what is ordered, or the run was stopped too early
  double bound{};                  // of the cost of every cutting at these lengths
  bool infeasible{};               // proved: there is no cutting
  int fewest_markers{1};           // no cutting that is cheaper than the bound has fewer
  std::vector<Candidate> near;     // candidates that are not cut, those first that add least to the bound
  std::size_t candidates{};        // how many were considered
  int nodes{};                     // of all integer programs
};

[[nodiscard]] SearchResult search(const orders::Problem& problem, const Lengths& lengths,
                                  const SearchSettings& settings, const std::optional<Cutting>& start = {},
                                  std::stop_token stop = {});

}  // namespace selvage::planning::cheapest
