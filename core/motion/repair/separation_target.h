// Where two overlapping pieces are to part: the depth of their overlap, and a relative position just outside their
// Minkowski sum about which a free region can be chosen [Li94 5.2, 7.1].  Shared by healing and separation.
#pragma once

#include "core/scene/scene.h"

namespace selvage::motion::repair {

// How the position is chosen.
enum class TargetRule {
  kNearest,    // the nearest point of the sum's boundary
  kKernelRay,  // where the ray from the sum's kernel through the present position leaves the sum [Li94 5.2]
};

struct SeparationTarget {
  double depth{};  // how far the pieces must part, spacing included; the same for either rule; lattice units
  Vec about;       // a relative position: the present one when the pieces are only too close
};
// REQUIRES: the pair overlaps, or is closer than the marker's spacing.
[[nodiscard]] SeparationTarget separation_target(const scene::Scene& scene, marker::PiecePair pair, TargetRule rule);

// The same for two pieces of which not both lie as the scene says: at the relative position r, overlapping or too
// close. `depth` leaves the spacing out.
[[nodiscard]] SeparationTarget separation_target(const minkowski::Obstacle& obstacle, Vec r, bool overlapping,
                                                 TargetRule rule);

}  // namespace selvage::motion::repair
