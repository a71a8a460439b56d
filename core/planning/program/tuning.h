// The tuning constants of column generation and of remnants.  All of them count work; none is a time.
#pragma once

#include <cstddef>

namespace selvage::planning::program {

inline constexpr std::size_t kPricingNodes = 200'000;  // of one search for the ratio of the least reduced cost
inline constexpr int kGenerations = 200;               // rounds of column generation
inline constexpr double kPricingTolerance = 1e-7;     // of the bound: reduced costs above minus this end the generation
inline constexpr std::size_t kRemnantSteps = 20'000;  // of choosing what lies on the remnants of a colour

}  // namespace selvage::planning::program
