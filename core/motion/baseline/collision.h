// Collision detection for two translating pieces [Li94 2.2], in the space of their relative position: a point moves
// along a ray, and collides where the ray meets their Minkowski sum.
//
// Each edge of the sum is one vertex against one edge of the pieces, and a supporting pair [Li94 2.6]; so this is the
// thesis' loop over vertices and edges without the pairs that cannot collide.  Lengths are lattice units; a velocity is
// lattice units per unit of time.
#pragma once

#include "core/minkowski/cache.h"
#include "core/model/position_model.h"

namespace selvage::motion::baseline {

// A position that is not on the lattice: the nearest lattice point and the remainder.
struct FinePosition {
  Vec at;
  RealVec rest;
};

struct CollisionSettings {
  double clearance{};  // they collide when they come this close
  double touching{};   // edges nearer than this now are contacts, which non-penetration rows take care of
  double horizon{};    // the latest time that is looked at
};

// The time until `r`, moving with `velocity`, comes within the clearance of the obstacle; the horizon when it does not.
// REQUIRES: clearance < touching.
[[nodiscard]] double collision_time(const minkowski::Obstacle& obstacle, const FinePosition& r, const RealVec& velocity,
                                    const CollisionSettings& settings);

}  // namespace selvage::motion::baseline
