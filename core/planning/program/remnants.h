// Which plies of a cutting lie on remnants: those that save most.
//
// Every colour is a problem of its own, with several knapsacks: a remnant holds whole units of plies, of one marker or
// of several, one behind the other.  What is saved grows with the length that is covered.  All ways are tried, those
// that fill the first remnants most at first, up to a number of steps that cuttings of a few markers hardly reach.
//
// Units: millimetres; money in the caller's currency; plies are counted in units (orders::Problem::plies_of_unit).
#pragma once

#include <vector>

#include "core/planning/orders/order.h"
#include "core/planning/program/cutting.h"

namespace selvage::planning::program {

struct OnRemnants {
  std::vector<std::vector<int>> units;  // by use, by remnant
  double length{};                      // of cloth, together
};

// Laws.  (1) No remnant is longer covered than it is, and no use has more units on the remnants of a colour than it has
// in that colour.  (2) Nothing lies on remnants whose cloth is as dear as that of rolls.  (3) Within the steps, no
// other choice covers more.  Deterministic.
[[nodiscard]] OnRemnants spread_on_remnants(const orders::Problem& problem, const std::vector<Use>& uses);

// What any plan saves at most by the remnants of a colour, and of all colours together.
[[nodiscard]] double most_saved(const orders::Problem& problem);
// The remnants of a colour, added up.
[[nodiscard]] double remnant_length(const orders::Problem& problem, std::size_t colour);
// How many units of this length a remnant holds; 0 when its cloth saves nothing.
[[nodiscard]] int units_held(const orders::Problem& problem, const orders::Remnant& remnant, double unit_length);

}  // namespace selvage::planning::program
