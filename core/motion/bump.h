// Bumping: one piece moves in a direction as far as it can, sliding along what it meets, while everything else stays
// [Li94 4.2.3].  Two variables: no linear program, only half-planes.
#pragma once

#include "core/motion/scene.h"

namespace selvage {

struct Bump {
  Vec at;                                // where the piece ends up; proved valid
  double gain{};                         // how far it came in the direction, lattice units; never negative
  std::vector<std::uint32_t> touching;   // the pieces that hold it there
};

// The local optimum of the direction (dx, dy), which need not have unit length: no way of sliding leads farther by more
// than rounding.  A fixed piece, or the direction (0, 0), stays.  The strip's right edge is the marker's present end, or the
// cloth's when it has one.
// REQUIRES: the scene's pieces are valid.
[[nodiscard]] Bump bump(const Scene& scene, std::uint32_t piece, double dx, double dy);

}  // namespace selvage
