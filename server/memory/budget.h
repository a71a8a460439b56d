// How the memory of a daemon is divided among what clients can make grow.
#pragma once

#include <cstddef>
#include <optional>

namespace selvage::server::memory {

// Bytes; together with kProgram they are the whole.
struct Budget {
  std::size_t sums{};     // cached Minkowski sums
  std::size_t traffic{};  // requests that are received or answered, and answers not yet sent
  std::size_t markers{};  // markers, their histories, and the answers kept for retries
};

inline constexpr std::size_t kProgram = std::size_t{48} << 20;       // the program itself, its threads and queues
inline constexpr std::size_t kLeastMarkers = std::size_t{16} << 20;  // otherwise the daemon would be of no use

// `sums`, `traffic`: instead of an eighth and a quarter of the whole, which are 256 and 512 MiB at most.  Nothing if
// less than kLeastMarkers would remain.
[[nodiscard]] std::optional<Budget> divided(std::size_t whole, std::optional<std::size_t> sums = {},
                                            std::optional<std::size_t> traffic = {});

}  // namespace selvage::server::memory
