// A cutting: which markers are cut, how often and in which colours; and what it costs.
//
// Units: money in the caller's currency.  Plies are counted in units (orders::Problem::plies_of_unit).
#pragma once

#include <optional>
#include <vector>

#include "core/planning/orders/order.h"
#include "core/planning/orders/ratio.h"

namespace selvage::planning::program {

// A marker that may be cut, of a length that is known or estimated.
struct Candidate {
  orders::Ratio ratio;
  double length{};  // millimetres
  friend bool operator==(const Candidate&, const Candidate&) = default;
};

// What a candidate costs when its cloth comes from rolls, and how much of it may be cut.
struct Price {
  double unit{}, lay{}, marker{};  // of each unit of plies, of each lay, of cutting the marker at all
  std::vector<int> most;           // units, by colour
  int most_units{};                // of all colours together
};
[[nodiscard]] Price price_of(const orders::Problem& problem, const Candidate& candidate);
// Whether the marker with its end loss is no longer than the table.
[[nodiscard]] bool fits_table(const orders::Problem& problem, double length);

// A marker that is cut.
struct Use {
  Candidate candidate;
  std::vector<int> units;  // by colour; at least one is above 0
  friend bool operator==(const Use&, const Use&) = default;
};
struct Cutting {
  std::vector<Use> uses;  // each ratio at most once, in lexical order
  double cost{};
  friend bool operator==(const Cutting&, const Cutting&) = default;
};

// The fewest lays that the units of a marker need.
[[nodiscard]] int lays_of(const orders::Problem& problem, const Use& use);
// Of one marker, with all of its cloth from rolls; and of all together, with what lies on remnants (remnants.h).
[[nodiscard]] double cost_of(const orders::Problem& problem, const Use& use);
[[nodiscard]] double cost_of(const orders::Problem& problem, const std::vector<Use>& uses);
// The length of cloth that the plies take, with their end losses but without splices; millimetres.
[[nodiscard]] double cloth_of(const orders::Problem& problem, const std::vector<Use>& uses);
// How many garments are cut, by colour, by size.
[[nodiscard]] std::vector<std::vector<int>> delivered_by(const orders::Problem& problem, const std::vector<Use>& uses);
// Whether that is what the order and its limits allow, for every colour and size; exact.
[[nodiscard]] bool delivers(const orders::Problem& problem, const std::vector<Use>& uses);

}  // namespace selvage::planning::program
