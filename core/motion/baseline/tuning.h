// The numerical constants of velocity-based compaction.
#pragma once

namespace selvage::motion::baseline {

struct VelocityTuning {
  double clearance{3};         // lattice units kept between slanted edges, as room for rounding
  double least_touching{0.5};  // lattice units beyond the clearance within which pieces are in contact
  double restoring{1e5};       // units of time in which a contact gets its clearance back
  double fastest{1};           // lattice units per unit of time, on each axis [Li94 2.5]
  friend bool operator==(const VelocityTuning&, const VelocityTuning&) = default;
};

}  // namespace selvage::motion::baseline
