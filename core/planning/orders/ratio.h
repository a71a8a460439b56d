// The ratio of a marker: how many bundles of each size it holds.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/planning/orders/order.h"

namespace selvage::planning::orders {

using Ratio = std::vector<int>;  // by size

[[nodiscard]] int bundles_in(const Ratio& ratio);
[[nodiscard]] double area_of(const Order& order, const Ratio& ratio);       // of the pieces
[[nodiscard]] double perimeter_of(const Order& order, const Ratio& ratio);  // of the pieces, added up

// How many ratios have 1 to `bundles` bundles of this number of sizes; `most` when there are more than that.
[[nodiscard]] std::size_t number_of_ratios(std::size_t sizes, int bundles, std::size_t most);
// Calls visit(ratio) for each of them, in lexical order.
void for_each_ratio(std::size_t sizes, int bundles, const std::function<void(const Ratio&)>& visit);
// The ratios with one bundle more, one fewer, or one of another size, of 1 to `bundles` bundles.
[[nodiscard]] std::vector<Ratio> neighbours_of(const Ratio& ratio, int bundles);
// One bundle of this size.
[[nodiscard]] Ratio single(std::size_t sizes, std::size_t size);

// The most units of plies (Problem::plies_of_unit) of this colour that cut no more garments than allowed; 0 when the
// ratio has a size that is not ordered in this colour.
[[nodiscard]] int most_units(const Problem& problem, const Ratio& ratio, std::size_t colour);

}  // namespace selvage::planning::orders
