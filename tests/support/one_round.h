// One round of each motion, and what it takes: for measuring how programs grow, and for seeing that they do not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/marker/marker.h"
#include "core/minkowski/cache.h"
#include "core/scene/run.h"

namespace selvage::test {

struct OneRound {
  const char* motion;
  std::size_t pieces;  // of markers with more it takes too long to be waited for
  void (*run)(const Marker& marker, const scene::Run& run);
};
// By name.  Those of one piece take the one in the middle of the list; "whole" is the naive model: every piece, pair
// and row at once.
[[nodiscard]] std::span<const OneRound> one_round_of_each();

struct Work {
  int programs{};
  scene::ProgramSize largest;  // each figure on its own
  std::uint64_t sums{};        // asked for, in the cache or not
};
// Starts from an empty cache.
[[nodiscard]] Work work_of(const OneRound& round, const Marker& marker);

}  // namespace selvage::test
