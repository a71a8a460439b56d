// Every motion of the core, with random wishes: what the soak does to a marker, again and again.
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

// What a motion is given besides its own wishes, which it draws.
struct Occasion {
  Random& random;
  const scene::Run& run;
};

struct Answer {
  Marker marker;
  Leave leave;
  std::string contradiction{};      // between what the motion tells and what it did; empty when there is none
  bool apart{true};                 // false: says itself that it leaves overlaps
  std::optional<Marker> started{};  // from what, when that was not the marker as given
};

// Errors: the motion's own.
using RandomMotion = Result<Answer> (*)(const Marker& start, const Occasion& occasion);

struct NamedMotion {
  std::string_view name;
  int weight{};  // how often, beside the others
  bool mends{};  // takes a marker whose pieces overlap by a little
  RandomMotion run{};
};
[[nodiscard]] std::span<const NamedMotion> motions();
// By weight.
[[nodiscard]] const NamedMotion& drawn_motion(Random& random);

}  // namespace selvage::test
