// A plan as a few lines for people, and the words that the page shares with them.
#pragma once

#include <string>

#include "protocol/json/value.h"

namespace selvage::protocol::plans {

inline constexpr double kMetre = 1000;  // millimetres

// REQUIRES of the following: `plan` is a result of plan.cut.

// Cost, cloth, bound and one line for each marker.
[[nodiscard]] std::string plan_text(const Json& plan);

// "S x 1, M x 2"
[[nodiscard]] std::string ratio_text(const Json& marker);
// `value` with this number of decimals.
[[nodiscard]] std::string decimals(double value, int places);
// "1.25 m"; from millimetres.
[[nodiscard]] std::string metres(const Json& length);
// "40 red, 3 blue from remnant 2": the plies of a lay.
[[nodiscard]] std::string plies_text(const Json& lay);
// How far the cost may lie above the least, as a part of it.
[[nodiscard]] double gap_of(const Json& plan);

}  // namespace selvage::protocol::plans
