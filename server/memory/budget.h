// How the daemon's memory is divided among everything that clients can make grow.
#pragma once

#include <cstddef>
#include <optional>

namespace selvage::server::memory {

// In bytes; together with kProgram they add up to the whole.
struct Budget {
  std::size_t sums{};     // cached Minkowski sums
  std::size_t traffic{};  // requests that are received or answered, and answers not yet sent
  std::size_t markers{};  // markers, their histories, and the answers kept for retries
};

inline constexpr std::size_t kProgram = std::size_t{48} << 20;       // the program itself, its threads and queues
inline constexpr std::size_t kLeastMarkers = std::size_t{16} << 20;  // with less, the daemon would be useless

// `sums` and `traffic` replace the defaults: an eighth of the whole, at most 256 MiB, and a quarter, at most 512 MiB.
// Returns nothing if less than kLeastMarkers would remain for markers.
[[nodiscard]] std::optional<Budget> divided(std::size_t whole, std::optional<std::size_t> sums = {},
                                            std::optional<std::size_t> traffic = {});

}  // namespace selvage::server::memory
