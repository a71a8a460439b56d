// Every motion of the core, as registered for tests.  A motion is registered once, in a source of this folder and in
// the list of motion_cases.cpp; from there
//   - the laws (tests/laws) and the soak (tests/soak) run it with random arguments, and the judge checks its answers;
//   - the size of its linear programs is pinned (tests/pins) and measured (bench/measure).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/minkowski/cache.h"
#include "core/scene/run.h"
#include "tests/judge/judge.h"
#include "tests/support/random.h"

namespace selvage::test {

// What a motion gets in addition to the marker; it draws its own arguments at random.
struct Occasion {
  Random& random;
  const scene::Run& run;
};

struct Answer {
  Marker marker;
  Leave leave;
  std::string contradiction{};      // between what the motion reports and what it did; empty when there is none
  bool apart{true};                 // false: the motion reports that overlaps remain
  std::optional<Marker> started{};  // the marker that the motion started from, if it changed the given one first
};

// Errors: those of the motion.
using RandomMotion = Result<Answer> (*)(const Marker& start, const Occasion& occasion);

inline constexpr std::size_t kAnySize = std::numeric_limits<std::size_t>::max();

// One round of a motion with fixed arguments.  Motions of a single piece move the one in the middle of the list;
// "whole" marks the naive model, which contains every piece, pair and row.
struct OneRound {
  const char* motion;
  std::size_t pieces;  // with more pieces it takes too long
  void (*run)(const Marker& marker, const scene::Run& run);
};

struct MotionCase {
  std::string_view name;
  int weight{};    // relative frequency in the soak
  bool repairs{};  // accepts a marker whose pieces overlap slightly, and repairs it
  RandomMotion run{};
  std::vector<OneRound> rounds{};
};
[[nodiscard]] const std::vector<MotionCase>& motion_cases();
// Draws a motion with probability proportional to its weight.
[[nodiscard]] const MotionCase& drawn_motion(Random& random);

// All rounds of all motions, sorted by name.
[[nodiscard]] std::vector<OneRound> one_round_of_each();

// The linear programs and sums that one round needs.
struct Work {
  int programs{};
  scene::ProgramSize largest;  // the maximum of each figure over all programs
  std::uint64_t sums{};        // number of sums requested, cached or not
};
// Runs the round with an empty cache.
[[nodiscard]] Work work_of(const OneRound& round, const Marker& marker);

}  // namespace selvage::test
