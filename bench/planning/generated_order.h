// Orders for measurements, from a seed.
#pragma once

#include <cstdint>

#include "core/planning/orders/order.h"

namespace selvage::bench {

struct OrderShape {
  std::size_t sizes{5}, colours{3};
  int bundles{6};
};

// A trousers style whose sizes grow by 3 % in area; 20 to 150 garments of each colour and size; standard limits and
// costs.  Deterministic.
[[nodiscard]] planning::orders::Problem generated_order(std::uint64_t seed, const OrderShape& shape);

}  // namespace selvage::bench
