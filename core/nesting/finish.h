// The end of a nesting: small rotations of the pieces, which the search itself does not make.
//
// Pieces are tilted within the limits of their shapes.  Those whose shapes may turn freely are turned by up to half of
// the angle between the rotations that the search tries, so that every rotation can be reached; this angle becomes a
// part of their rotation.  Fixed pieces keep their orientation.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/marker/marker.h"
#include "core/scene/run.h"

namespace selvage::nesting {

struct Finish {
  Marker marker;  // valid, proved in integers
  Coord length{};
  int programs{};
};

// Whether some piece of the marker may tilt.
[[nodiscard]] bool may_tilt(const Marker& marker);

// The marker made shorter by compaction with tilts [Li94 6.2]; nothing when that gains nothing.  `elapsed` as in
// NestSettings: the motion is stopped when it reaches 1.  `rounds`: at most this many rounds of tilts; none: as many as
// at standard accuracy.
// REQUIRES: the marker is valid; `fixed` has an entry for each of its placed pieces.
[[nodiscard]] std::optional<Finish> finished(const Marker& marker, const std::vector<bool>& fixed,
                                             const std::function<double()>& elapsed, const scene::Run& run,
                                             std::optional<int> rounds = std::nullopt);

}  // namespace selvage::nesting
