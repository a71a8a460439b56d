// A plan as a few lines of text, and the phrases that these lines share with the page (plan_page.h).
#pragma once

#include <string>

#include "protocol/json/value.h"

namespace selvage::protocol::plans {

inline constexpr double kMetre = 1000;  // millimetres

// REQUIRES, of all functions below: `plan` is a result of plan.cut, and `marker` and `lay` are parts of one.

// The cost, the gap to the bound and the cloth; then a line for each marker, for each remnant and for the rolls of each
// colour.
[[nodiscard]] std::string plan_text(const Json& plan);

// "S x 1, M x 2"
[[nodiscard]] std::string ratio_text(const Json& marker);
// `value` with `places` decimals.
[[nodiscard]] std::string decimals(double value, int places);
// "1.25 m", from a number of millimetres.
[[nodiscard]] std::string metres(const Json& length);
// "40 red, 3 blue from remnant 2": the plies of a lay.
[[nodiscard]] std::string plies_text(const Json& lay);
// The gap between the cost and the bound, as a fraction of the cost.
[[nodiscard]] double gap_of(const Json& plan);

}  // namespace selvage::protocol::plans
