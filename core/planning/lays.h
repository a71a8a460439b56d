// The lays of a plan, and the cloth under them: which plies lie on remnants, and how many rolls and splices the others
// take when they are spread one after the other.
// Units: millimetres.
#pragma once

#include <cstddef>
#include <vector>

#include "core/planning/orders/order.h"
#include "core/planning/program/cutting.h"

namespace selvage::planning {

// A lay: a marker with the plies under it.
struct Lay {
  std::size_t marker{};            // position in Cutting::uses
  std::vector<int> plies;          // by colour
  std::vector<int> on_remnants{};  // of those, by remnant
  friend bool operator==(const Lay&, const Lay&) = default;
};
// The units of every marker as lays that are as full as they can be, colour by colour; those on remnants first.
[[nodiscard]] std::vector<Lay> lays_of(const orders::Problem& problem, const program::Cutting& cutting);

// The cloth of a colour that comes from rolls.  With rolls of a length, they are spread one after the other; where one
// ends within a ply, the ply is spliced, and where no more of one is left than a splice takes, the ply begins with the
// next roll.
struct Rolls {
  double cloth{};  // of the plies, with end losses
  int rolls{};     // that are begun; 0 when they have no end
  int splices{};
  double lost{};  // in overlaps and in ends of rolls that are too short
  double left{};  // of the last roll
  friend bool operator==(const Rolls&, const Rolls&) = default;
};
// By colour.  Law: rolls * length of a roll = cloth + lost + left.
[[nodiscard]] std::vector<Rolls> rolls_of(const orders::Problem& problem, const program::Cutting& cutting,
                                          const std::vector<Lay>& lays);

}  // namespace selvage::planning
