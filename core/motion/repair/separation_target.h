// Where two overlapping pieces are to be separated to: the depth of their overlap, and a relative position just outside
// their Minkowski sum about which a free region can be chosen [Li94 5.2, 7.1].  Used by repair, separation and tilting.
#pragma once

#include "core/scene/scene.h"

namespace selvage::motion::repair {

// How the position is chosen.
enum class TargetRule {
  kNearest,    // the nearest point of the sum's boundary
  kKernelRay,  // where the ray from the sum's kernel through the present position leaves the sum [Li94 5.2]
};

struct SeparationTarget {
  double depth{};  // the shortest move that separates them as far as they must be, whatever the rule: with the spacing,
                   // or less the allowance of those that may overlap; lattice units
  Vec about;       // the relative position; the present one when the pieces are only too close
};
// REQUIRES: the pair overlaps by more than its allowance, or is closer than its spacing.
[[nodiscard]] SeparationTarget separation_target(const scene::Scene& scene, marker::PiecePair pair, TargetRule rule);

// The same for two pieces at the relative position r, overlapping or too close, that need not be pieces of a scene.
// `depth` does not include the spacing.
[[nodiscard]] SeparationTarget separation_target(const minkowski::Obstacle& obstacle, Vec r, bool overlapping,
                                                 TargetRule rule);

}  // namespace selvage::motion::repair
