// Why something holds at a node of a search: the decisions on the way to the node from which it was concluded.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace selvage::packing::programs {

// A set of decisions, one bit for each, in the order in which they were made.  The last bit stands for all decisions
// after the first 63.
using Reasons = std::uint64_t;

inline constexpr Reasons kAnyway = 0;
inline constexpr Reasons kAllDecisions = ~Reasons{0};
inline constexpr std::size_t kToldApart = 63;  // decisions that have a bit of their own

[[nodiscard]] inline Reasons decision(std::size_t number) {
  return Reasons{1} << std::min(number, kToldApart);
}

// The reasons but for one decision, where it can be told apart.
[[nodiscard]] inline Reasons without(Reasons reasons, std::size_t number) {
  return number < kToldApart ? reasons & ~decision(number) : reasons;
}

}  // namespace selvage::packing::programs
