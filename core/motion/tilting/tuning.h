// The tuning constants of tilting.  Where no other source is named, the values were tuned on the example markers
// (docs/measurements/tilt.md).
#pragma once

#include <array>

#include "core/geometry/lattice.h"

namespace selvage::motion::tilting {

// Of one step by linearisation.
struct TiltStepTuning {
  double overlap_price{100};  // of a unit of overlap that stays, relative to a unit of the marker's length
  double clearance{1e-7};     // part of the width that programs keep pieces apart, for what is not linear in a turn,
  Coord least_clearance{3};   // plus lattice units, for the rounding of outlines
  double least_arc{1};        // lattice units that a turn moves a piece's farthest vertex: less changes only rounding
  double length_spare{1e-2};  // model units by which a program's length may grow, for rows' margins
  friend bool operator==(const TiltStepTuning&, const TiltStepTuning&) = default;
};

struct TiltTuning {
  double least_part{1.0 / 8};      // of the first step: shorter steps are not tried
  int corrections{3};              // programs that correct one step's errors of second order,
  double correction_turn{0.1};     // each turning at most this part of what the one before did
  int separation_rounds{20};       // when corrections leave overlaps
  double separation_growth{5e-3};  // part of the length by which that separation may lengthen the marker
  std::array<double, 3> perturbation_reach{1, 3, 0.5};  // of a step: how far perturbations go, in turn
  double perturbation_twist{0.3};                       // of a perturbation: torques relative to forces
  TiltStepTuning step{};
  friend bool operator==(const TiltTuning&, const TiltTuning&) = default;
};

}  // namespace selvage::motion::tilting
