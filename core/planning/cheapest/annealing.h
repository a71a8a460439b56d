// Simulated annealing over cuttings of a given number of markers.
//
// A state has the ratios of its markers, some of which may lie unused, and the units of plies of every colour.  A step
// changes a ratio or two by a bundle, replaces a marker, or changes a number of plies; then the plies of every colour
// are changed, by one or two markers at a time, as long as that makes the state cheaper.  Garments beyond what the
// limits allow are paid for.  Dearer states are accepted with a falling probability, as usual [KGV83].
//
// This finds a few markers that deliver an order nearly exactly.  An integer program rarely does, because its
// relaxation mixes small parts of many.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>

#include "core/planning/cheapest/lengths.h"

namespace selvage::planning::cheapest {

struct AnnealingSettings {
  std::size_t markers{};  // at most
  int steps{};
  double scale{};  // about what the order costs: temperatures are parts of it
  std::uint64_t seed{};
};

// The cheapest cutting that was seen; none if no state delivered what is ordered, or the run was stopped before.
// Deterministic.  REQUIRES: at least one marker; some ratio may be cut.
[[nodiscard]] std::optional<program::Cutting> anneal(const orders::Problem& problem, const Lengths& lengths,
                                                     const AnnealingSettings& settings, std::stop_token stop = {});

}  // namespace selvage::planning::cheapest
