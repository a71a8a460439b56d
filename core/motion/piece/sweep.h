// Sweeps of single-piece moves: every piece in turn is bumped to the left, in the order of the left ends
// [Li94 1.2.2, 4.2.3].
#pragma once

#include "core/scene/run.h"
#include "core/scene/scene.h"
#include "core/scene/stop_reason.h"

namespace selvage::motion::piece {

struct SweepSettings {
  int sweeps{200};          // at most this many
  double least_gain{1e-7};  // sweeps end with the first one in which all moves add up to less than this part of
                            // the width
  friend bool operator==(const SweepSettings&, const SweepSettings&) = default;
};

// Sweeps until nothing moves.  The pieces stay valid, and none moves to the right; when cancelled, it stops between two
// bumps.  Reports a round for every sweep, and adds their number to `sweeps`.
// REQUIRES: the scene's pieces are valid.
[[nodiscard]] scene::StopReason sweep_until_still(scene::Scene& scene, const SweepSettings& settings,
                                                  const scene::Run& run, int& sweeps);

}  // namespace selvage::motion::piece
