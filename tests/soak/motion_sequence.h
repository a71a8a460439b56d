// A sequence of random motions on one marker, with every result judged.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/marker/marker.h"
#include "core/minkowski/cache.h"
#include "tests/support/random.h"

namespace selvage::test {

struct Fault {
  int step{};  // the first motion is step 1
  std::string motion, what;
  Marker before;  // the marker given to the motion
};

// What a motion begins after a stop was requested.  Requirement: no more than this many programs, each of which its
// solver refuses at once, and no more Minkowski sums than the square of the number of pieces.
struct WorkAfterStop {
  std::uint64_t programs{}, sums{};
};
inline constexpr std::uint64_t kMostProgramsAfterStop = 2;

struct SequenceResult {
  int motions{};
  int refused{};  // motions that returned an error, which they may do for such markers
  std::map<std::string_view, int> of_each;
  WorkAfterStop after_stop;  // the most of any motion
  std::optional<Fault> fault;
};

inline constexpr int kMotionsPerSequence = 20;

// A random valid marker of a few pieces with every kind of constraint: locks, groups, buffers, spacing, margins, a
// limited length, and tilts.
[[nodiscard]] Marker constrained_marker(Random& random);

// Runs the sequence up to the first fault.  REQUIRES: `start` is valid.
[[nodiscard]] SequenceResult run_sequence(Marker start, int motions, Random& random, SumCache& sums);

}  // namespace selvage::test
