// The lengths that a search goes by, and with them which ratios may be cut.
#pragma once

#include <optional>
#include <vector>

#include "core/planning/orders/length_estimate.h"
#include "core/planning/program/cutting.h"

namespace selvage::planning::cheapest {

using program::Candidate;

struct Lengths {
  std::vector<Candidate> made;            // markers whose lengths are known, each ratio once
  orders::LengthEstimate estimate;        // of all others
  bool made_only{};                       // no others may be cut
  std::vector<orders::Ratio> unmakeable;  // ratios that may not be cut, whatever is estimated
  double beyond{};                        // by how much an estimate may exceed the table, because it may be wrong
};

// The marker of this ratio, when it may be cut: it is known to fit the table, or its estimate exceeds the table by at
// most `beyond`.  Single bundles that were not made always may, so that every order can be delivered.
[[nodiscard]] std::optional<Candidate> candidate_of(const orders::Problem& problem, const Lengths& lengths,
                                                    const orders::Ratio& ratio);

// The candidates that exist without being asked for: made markers and single bundles; `all`: those of every ratio.
[[nodiscard]] std::vector<Candidate> listed(const orders::Problem& problem, const Lengths& lengths, bool all);

}  // namespace selvage::planning::cheapest
