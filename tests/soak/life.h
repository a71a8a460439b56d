// The life of one random marker: motion after motion, every answer judged.
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
  int step{};  // from 1
  std::string motion, what;
  Marker before;  // what the motion was given
};

struct Life {
  int motions{};
  int refused{};  // answered with an error that they may answer with
  std::map<std::string_view, int> of_each;
  std::optional<Fault> fault;
};

inline constexpr int kMotionsOfALife = 20;

// A marker of a few pieces with all that constrains them: locks, groups, buffers, spacing, margins, the cloth's end,
// tilts.  Valid.
[[nodiscard]] Marker constrained_marker(Random& random);

// Ends at the first fault.  REQUIRES: start is valid.
[[nodiscard]] Life live(Marker start, int motions, Random& random, SumCache& sums);

}  // namespace selvage::test
