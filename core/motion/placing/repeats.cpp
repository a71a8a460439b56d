#include "core/motion/placing/repeats.h"

#include <algorithm>
#include <cmath>

namespace selvage::motion::placing {
namespace {

// The jumps on one axis whose position is among the `2 * reach + 1` nearest to the wanted one.
std::vector<Coord> jumps_along(Coord from, Coord wanted, Coord repeat, Coord reach) {
  if (repeat == 0) return {0};
  const Coord nearest = std::llround(static_cast<double>(wanted - from) / static_cast<double>(repeat));
  std::vector<Coord> jumps;
  for (Coord k = -reach; k <= reach; ++k) jumps.push_back((nearest + k) * repeat);
  return jumps;
}

}  // namespace

double least_distance(Vec at, Vec wanted, Vec repeat) {
  return std::hypot(repeat.x == 0 ? 0 : static_cast<double>(at.x - wanted.x),
                    repeat.y == 0 ? 0 : static_cast<double>(at.y - wanted.y));
}

std::vector<Vec> jumps_towards(Vec from, Vec wanted, Vec repeat, std::size_t count) {
  const bool plaid = repeat.x != 0 && repeat.y != 0;
  const auto each = static_cast<double>(count);
  const auto reach = static_cast<Coord>(plaid ? std::sqrt(each) : each) / 2;
  std::vector<Vec> jumps;
  for (const Coord x : jumps_along(from.x, wanted.x, repeat.x, reach)) {
    for (const Coord y : jumps_along(from.y, wanted.y, repeat.y, reach)) jumps.push_back({x, y});
  }
  std::stable_sort(jumps.begin(), jumps.end(), [&](Vec a, Vec b) {
    return least_distance(from + a, wanted, repeat) < least_distance(from + b, wanted, repeat);
  });
  return jumps;
}

}  // namespace selvage::motion::placing
