// The search for the cheapest cutting at given lengths.
//
// Method.  The relaxation gives a bound and says what every candidate would add to it.  An integer program over the
// candidates that add least gives a first cutting; programs over its markers and their neighbours (one bundle more,
// fewer, or of another size) improve it; a last one over all candidates that could still be better closes the gap, as
// far as its nodes go.
//
// Laws.  (1) The answer delivers what is ordered, checked in integers.  (2) bound <= cost; when they are equal, no
// cutting of any ratio is cheaper at these lengths.  (3) The answer costs no more than `start`.  (4) Deterministic.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/planning/orders/length_estimate.h"
#include "core/planning/program/cutting.h"
#include "core/planning/program/tuning.h"

namespace selvage::planning::program {

// The lengths in use.
struct Lengths {
  std::vector<Candidate> made;            // markers whose lengths are known, each ratio once
  orders::LengthEstimate estimate;        // of all others
  bool made_only{};                       // no others may be cut
  std::vector<orders::Ratio> unmakeable;  // ratios that may not be cut, whatever is estimated
};

struct SearchSettings {
  bool thorough{true};  // false: without the program that closes the gap, so that the bound is the relaxation's
  double gap{0.01};     // relative: the search ends when cost - bound is at most this part of the cost
  std::size_t most_listed{kMostListed};
  SearchTuning tuning{};
};

struct SearchResult {
  std::optional<Cutting> cutting;  // none: no cutting delivers what is ordered, or the run was stopped before there was
  double bound{};                  // of the cost of every cutting at these lengths
  bool infeasible{};               // proved: there is no cutting
  std::vector<Candidate> near;     // candidates that are not cut, those first that add least to the bound
  std::size_t candidates{};        // how many were considered
  int nodes{};                     // of all integer programs
};

[[nodiscard]] SearchResult search(const orders::Problem& problem, const Lengths& lengths,
                                  const SearchSettings& settings, const std::optional<Cutting>& start = {},
                                  std::stop_token stop = {});

}  // namespace selvage::planning::program
