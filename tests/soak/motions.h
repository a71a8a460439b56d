// Every motion of the core with random arguments, as used by the soak test.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/scene/run.h"
#include "tests/soak/judge.h"
#include "tests/support/random.h"

namespace selvage::test {

// What a motion is given besides the marker; it draws its own arguments at random.
struct Occasion {
  Random& random;
  const scene::Run& run;
};

struct Answer {
  Marker marker;
  Leave leave;
  std::string
      contradiction{};  // a contradiction between what the motion reports and what it did; empty when there is none
  bool apart{true};     // false: the motion reports that overlaps remain
  std::optional<Marker> started{};  // the marker that the motion started from, if it changed the given one first
};

// Errors: those of the motion.
using RandomMotion = Result<Answer> (*)(const Marker& start, const Occasion& occasion);

struct NamedMotion {
  std::string_view name;
  int weight{};    // relative frequency
  bool repairs{};  // accepts a marker whose pieces overlap slightly, and repairs it
  RandomMotion run{};
};
[[nodiscard]] std::span<const NamedMotion> motions();
// Draws a motion with probability proportional to its weight.
[[nodiscard]] const NamedMotion& drawn_motion(Random& random);

}  // namespace selvage::test
