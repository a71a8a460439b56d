#include "server/memory/budget.h"

#include <algorithm>

namespace selvage::server::memory {

std::optional<Budget> divided(std::size_t whole, std::optional<std::size_t> sums, std::optional<std::size_t> traffic) {
  constexpr std::size_t kMostSums = std::size_t{256} << 20, kMostTraffic = std::size_t{512} << 20;
  Budget budget{.sums = sums.value_or(std::min(whole / 8, kMostSums)),
                .traffic = traffic.value_or(std::min(whole / 4, kMostTraffic))};
  const std::size_t other = kProgram + budget.sums + budget.traffic;
  if (whole < other + kLeastMarkers) return std::nullopt;
  budget.markers = whole - other;
  return budget;
}

}  // namespace selvage::server::memory
