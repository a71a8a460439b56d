// The plies of one colour under given markers: the cheapest that deliver what is ordered of it, by trying all numbers
// within bounds.  For sets of a few markers.
//
// Units: plies are counted in units, and garments in those that one unit cuts (orders::Problem::plies_of_unit).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/planning/orders/order.h"
#include "core/planning/orders/ratio.h"

namespace selvage::planning::program {

// What may be delivered of a colour.
struct Window {
  std::vector<int> least, most;  // by size
};
[[nodiscard]] Window window_of(const orders::Problem& problem, std::size_t colour);

// A marker under which plies may lie.
struct Member {
  const orders::Ratio* ratio{};
  double unit{};  // what a unit of plies costs
};
struct Plies {
  std::vector<int> units;  // by member
  double cost{};
};
// Nothing when the members cannot deliver the window, or when the work is used up: every number that is tried takes one
// from `work`.  REQUIRES: no ratio is empty.
[[nodiscard]] std::optional<Plies> cheapest_plies(const Window& window, std::span<const Member> members,
                                                  std::uint64_t& work);

}  // namespace selvage::planning::program
