// Which plies of a cutting lie on remnants: the choice that saves most.
//
// Every colour is a problem of its own, with several knapsacks: a remnant holds whole units of plies, of one marker or
// of several, one behind the other.  The saving is proportional to the length that is used.  All ways are tried,
// beginning with those that fill the first remnants most, up to a number of steps that cuttings of a few markers rarely
// reach.
//
// Units: millimetres; money in the caller's currency; plies are counted in units (orders::Problem::plies_of_unit).
#pragma once

#include <vector>

#include "core/planning/orders/order.h"
#include "core/planning/program/cutting.h"

namespace selvage::planning::program {

struct OnRemnants {
  std::vector<std::vector<int>> units;  // indexed by use, then by remnant
  double length{};                      // total length of cloth from remnants
};

// Laws.  (1) No more is used of a remnant than its length, and no use has more units on the remnants of a colour than
// it has in that colour.  (2) Nothing lies on remnants whose cloth costs as much as that of rolls.  (3) Unless the
// number of steps is exhausted, no other choice uses a greater length.  Deterministic.
[[nodiscard]] OnRemnants spread_on_remnants(const orders::Problem& problem, const std::vector<Use>& uses);

// The most that any plan can save by using the remnants of all colours.
[[nodiscard]] double most_saved(const orders::Problem& problem);
// The total length of the remnants of a colour.
[[nodiscard]] double remnant_length(const orders::Problem& problem, std::size_t colour);
// How many units of this length a remnant holds; 0 when its cloth saves nothing.
[[nodiscard]] int units_held(const orders::Problem& problem, const orders::Remnant& remnant, double unit_length);

}  // namespace selvage::planning::program
