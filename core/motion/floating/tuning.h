// The tuning constants of floating.
#pragma once

#include <cstddef>

#include "core/geometry/lattice.h"

namespace selvage::motion::floating {

struct FloatTuning {
  double trust_ahead{2};     // the next round's trust radius, as a multiple of the last round's farthest move
  double least_trust{0.05};  // the trust radius never shrinks below this part of the first round's
  double loaded{1e-6};       // smaller loads are rounding of the solver; all loads on the minimum add up to 1
  std::size_t measured_when_stopped{1000};  // gaps that a motion that is stopped still measures in one go
  Coord rounding{4};                        // lattice units that a critical gap may lose to rounding while others widen
  friend bool operator==(const FloatTuning&, const FloatTuning&) = default;
};

}  // namespace selvage::motion::floating
