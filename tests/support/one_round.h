// Runs one round of each motion and records the linear programs and sums that it needs.  Used to measure how the
// programs grow with the marker and to test that they stay small.
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
// All rounds, sorted by name.  Motions of a single piece move the one in the middle of the list.  "whole" marks the
// naive model, which contains every piece, pair and row.
[[nodiscard]] std::span<const OneRound> one_round_of_each();

struct Work {
  int programs{};
  scene::ProgramSize largest;  // the maximum of each figure over all programs
  std::uint64_t sums{};        // number of sums requested, cached or not
};
// Runs the round with an empty cache.
[[nodiscard]] Work work_of(const OneRound& round, const Marker& marker);

}  // namespace selvage::test
