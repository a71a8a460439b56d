// Why something holds at a node of a search: the decisions on the way to the node from which it was concluded.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace selvage::packing::programs {

// A set of decisions, one bit for each, in the order in which they were made.  The last bit stands for all decisions
// after the first 63.
using Reasons = std::uint64_t;

inline constexpr Reasons kUnconditional = 0;
inline constexpr Reasons kAllDecisions = ~Reasons{0};
inline constexpr std::size_t kDistinctDecisions = 63;  // decisions that have a bit of their own

[[nodiscard]] inline Reasons decision(std::size_t number) {
  return Reasons{1} << std::min(number, kDistinctDecisions);
}

// The reasons without one decision, if it has a bit of its own.
[[nodiscard]] inline Reasons without(Reasons reasons, std::size_t number) {
  return number < kDistinctDecisions ? reasons & ~decision(number) : reasons;
}

}  // namespace selvage::packing::programs
