// The ratio of a marker that divides an order into whole markers.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "protocol/trade/orders/order.h"

namespace selvage::protocol::trade::orders {

using Sums = std::vector<std::pair<std::string, std::int64_t>>;  // garments of each size, over all colours

void add_to(Sums& sums, const std::string& size, int garments);

// Gives the order the sums divided by their greatest common divisor as its ratio, with a note, unless it has a ratio.
// REQUIRES: sums that are not all 0, or a ratio.
void settle_ratio(Order& order, const Sums& sums);

}  // namespace selvage::protocol::trade::orders
