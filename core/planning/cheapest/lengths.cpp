#include "core/planning/cheapest/lengths.h"

#include <algorithm>

namespace selvage::planning::cheapest {

using orders::Ratio;
using program::fits_table;

std::optional<Candidate> candidate_of(const orders::Problem& problem, const Lengths& lengths, const Ratio& ratio) {
  if (std::ranges::find(lengths.unmakeable, ratio) != lengths.unmakeable.end()) return std::nullopt;
  const auto made = std::ranges::find(lengths.made, ratio, &Candidate::ratio);
  if (made != lengths.made.end()) {
    return fits_table(problem, made->length) ? std::optional{*made} : std::nullopt;
  }
  if (lengths.made_only) return std::nullopt;
  const double length = lengths.estimate.length_of(area_of(problem.order, ratio));
  if (orders::bundles_in(ratio) > 1 && !fits_table(problem, length - lengths.beyond)) return std::nullopt;
  return Candidate{ratio, length};
}

std::vector<Candidate> listed(const orders::Problem& problem, const Lengths& lengths, bool all) {
  const std::size_t sizes = problem.order.sizes.size();
  std::vector<Candidate> candidates;
  const auto add = [&](const Ratio& ratio) {
    if (auto candidate = candidate_of(problem, lengths, ratio)) candidates.push_back(*std::move(candidate));
  };
  if (all && !lengths.made_only) {
    orders::for_each_ratio(sizes, problem.limits.bundles, add);
    return candidates;
  }
  for (const Candidate& made : lengths.made) add(made.ratio);
  for (std::size_t size = 0; size < sizes; ++size) {
    const Ratio single = orders::single(sizes, size);
    if (std::ranges::find(lengths.made, single, &Candidate::ratio) == lengths.made.end()) add(single);
  }
  return candidates;
}

}  // namespace selvage::planning::cheapest
