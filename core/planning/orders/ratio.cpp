#include "core/planning/orders/ratio.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace selvage::planning::orders {

int bundles_in(const Ratio& ratio) {
  return std::accumulate(ratio.begin(), ratio.end(), 0);
}

double area_of(const Order& order, const Ratio& ratio) {
  double area = 0;
  for (std::size_t size = 0; size < ratio.size(); ++size) area += ratio[size] * order.sizes[size].area;
  return area;
}

double perimeter_of(const Order& order, const Ratio& ratio) {
  double perimeter = 0;
  for (std::size_t size = 0; size < ratio.size(); ++size) perimeter += ratio[size] * order.sizes[size].perimeter;
  return perimeter;
}

// There are C(sizes + bundles, bundles) ratios of at most this many bundles, one of which is empty.
std::size_t number_of_ratios(std::size_t sizes, int bundles, std::size_t most) {
  std::size_t count = 1;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(bundles); ++k) {
    count = count * (sizes + k) / k;
    if (count > most) return most;
  }
  return count - 1;
}

void for_each_ratio(std::size_t sizes, int bundles, const std::function<void(const Ratio&)>& visit) {
  Ratio ratio(sizes);
  int left = bundles;
  while (true) {
    // The next in lexical order: the last size grows, or what it has is given up for one more of the size before.
    std::size_t size = sizes - 1;
    while (left == 0) {
      left += ratio[size];
      ratio[size] = 0;
      if (size == 0) return;
      --size;
    }
    ++ratio[size];
    --left;
    visit(ratio);
  }
}

std::vector<Ratio> neighbours_of(const Ratio& ratio, int bundles) {
  std::vector<Ratio> neighbours;
  const int held = bundles_in(ratio);
  for (std::size_t size = 0; size < ratio.size(); ++size) {
    Ratio changed = ratio;
    if (held < bundles) {
      ++changed[size];
      neighbours.push_back(changed);
      --changed[size];
    }
    if (ratio[size] == 0) continue;
    --changed[size];
    if (held > 1) neighbours.push_back(changed);
    for (std::size_t other = 0; other < ratio.size(); ++other) {
      if (other == size) continue;
      ++changed[other];
      neighbours.push_back(changed);
      --changed[other];
    }
  }
  return neighbours;
}

Ratio single(std::size_t sizes, std::size_t size) {
  Ratio ratio(sizes);
  ratio[size] = 1;
  return ratio;
}

int most_units(const Problem& problem, const Ratio& ratio, std::size_t colour) {
  int most = std::numeric_limits<int>::max();
  for (std::size_t size = 0; size < ratio.size(); ++size) {
    if (ratio[size] > 0) most = std::min(most, problem.most(colour, size) / (ratio[size] * problem.plies_of_unit()));
  }
  return most;
}

}  // namespace selvage::planning::orders
