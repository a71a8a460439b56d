// The tuning constants of a repair (repair.h).  No answer becomes wrong with other values: more or fewer markers are
// repaired, with more or less motion.
#pragma once

namespace selvage::motion::repair {

struct RepairTuning {
  // Linear programs solved one after another, as rounding leaves overlaps of a unit or two.  One is nearly always
  // enough.
  int rounds{12};
  // Repair limits (repair.h): pairs and rows within this distance of each other are modelled, and the marker may grow
  // by as much when there is no room within its length.
  double reach{20};
  // What a unit of growth of the marker costs, and what a unit of a piece's motion costs: no motion is spared at the
  // price of length.
  double length_cost{1e3};
  double displacement_cost{1};
  // Column units by which the marker may always grow in a program, so that rows can have their margins.
  double spare_length{1e-2};

  friend bool operator==(const RepairTuning&, const RepairTuning&) = default;
};

}  // namespace selvage::motion::repair
