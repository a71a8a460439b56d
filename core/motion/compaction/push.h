// Pushing: all pieces move at once to follow forces on some of them, at fixed length of the marker.  This is vector
// compaction [Li94 4.2.2]; with the same force on every piece, gravity compaction [Li94 4.2.4].
#pragma once

#include <span>

#include "core/base/result.h"
#include "core/motion/compaction/compact.h"

namespace selvage::motion::compaction {

// A force on one piece.  Only directions and the forces' sizes relative to each other matter.
struct Force {
  PieceId piece;
  double x{}, y{};
};

// The goal that follows the forces, scaled so that the largest is 1.
// Errors: kOutOfRange for a force on a piece that does not exist, or a force that is not finite.
[[nodiscard]] Result<step::Goal> pushing_goal(std::span<const Force> forces, std::size_t pieces);

// The marker never becomes longer.
struct Push : repair::MotionResult {
  double gain{};  // sum over the forces, scaled so that the largest is 1, of force . displacement; lattice units
};

// Moves the pieces as far as the forces can move them; settings as for compaction (gravity is not used).
// Errors: those of repair_overlaps and of pushing_goal.
[[nodiscard]] Result<Push> push(const Marker& start, std::span<const Force> forces, const CompactionSettings& settings,
                                const scene::Run& run);

// The same force on every piece.
[[nodiscard]] std::vector<Force> gravity(const Marker& marker, double x, double y);

}  // namespace selvage::motion::compaction
