#include "bench/planning/generated_order.h"

#include <random>

namespace selvage::bench {

planning::orders::Problem generated_order(std::uint64_t seed, const OrderShape& shape) {
  std::mt19937_64 random{seed};
  planning::orders::Problem problem;
  problem.cloth.width = 1500;
  problem.limits.bundles = shape.bundles;
  for (std::size_t size = 0; size < shape.sizes; ++size) {
    const double growth = 1 + 0.03 * static_cast<double>(size);
    problem.order.sizes.push_back({"size " + std::to_string(34 + 2 * size), 1.45e6 * growth, 21'000 * growth});
  }
  for (std::size_t colour = 0; colour < shape.colours; ++colour) {
    problem.order.colours.push_back("colour " + std::to_string(colour + 1));
    auto& garments = problem.order.garments.emplace_back();
    for (std::size_t size = 0; size < shape.sizes; ++size) garments.push_back(20 + static_cast<int>(random() % 131));
  }
  return problem;
}

}  // namespace selvage::bench
