// Velocity-based compaction [Li94 chapter 2]: the pieces are rigid bodies without mass or friction, a piston at the
// marker's right end pushes to the left, and time passes from collision to collision.  In each step a linear program
// finds the pieces' velocities from the present contacts; then all move until the next contact.
//
// A baseline for compact(), which needs no time steps: its small steps are what makes this method slow [Li94 2.7].
// Departs: contacts and collisions are read from Minkowski sums (collision.h), which is faster than the loops of the
// thesis and gives the same steps; contacts keep a clearance of a few lattice units, so that the positions, which are
// not on the lattice here, stay valid when they are rounded to it.
#pragma once

#include "core/motion/baseline/tuning.h"
#include "core/motion/compaction/compact.h"

namespace selvage::motion::baseline {

struct VelocitySettings {
  int steps{10000};          // at most this many
  double horizon{0.1};       // the longest time step: the fastest piece moves by this part of the width
  double touching{1e-5};     // pieces this near, in parts of the width, are in contact
  double least_time{1e-7};   // a time step shorter than this (in the same measure) makes no progress, and
  int patience{50};          // this many such steps in a row end the motion
  double least_speed{1e-7};  // the piston at rest: slower than this part of the fastest piece
  double gravity{0.003};     // force on all pieces together, relative to the piston's
  lp::solver::SolverChoice solver{lp::solver::SolverChoice::kAutomatic};
  VelocityTuning tuning{};
  friend bool operator==(const VelocitySettings&, const VelocitySettings&) = default;
};

// Laws: those of compact(); the marker is valid after every step, proved in integers.  The answer's rounds are time
// steps; it returns the shortest marker met.
// Errors: those of repair_overlaps.
[[nodiscard]] Result<compaction::Compaction> compact_by_velocities(const Marker& start,
                                                                   const VelocitySettings& settings,
                                                                   const scene::Run& run);

}  // namespace selvage::motion::baseline
