// Coordinate descent: steps along x, y or a diagonal, longer ones after a success, shorter ones after a failure
// ([GVW25] refines its samples in the same way).
// Units: model units.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/nesting/layout/dice.h"
#include "core/nesting/layout/piece_set.h"

namespace selvage::nesting::local_search {

struct Position {
  double x{}, y{};
};
struct Descended {
  Position at;
  double loss{};
};

// Descends from the position, clamped to `room`, until steps are shorter than `limit` or the loss is 0.
// `loss(x, y, bound)` may return any value of at least `bound` when the loss is not below it.
template <class Loss>
[[nodiscard]] Descended descend(const Loss& loss, Position from, const RealBox& room, double step, double limit,
                                layout::Dice& dice) {
  constexpr double kLonger = 1.3;
  constexpr double kShorter = 0.35;
  enum Way : std::size_t { kAlongX, kAlongY, kRising, kFalling, kWays };
  const auto inside = [&room](Position at) {
    return Position{std::max(room.low_x, std::min(at.x, room.high_x)),
                    std::max(room.low_y, std::min(at.y, room.high_y))};
  };
  Descended best{inside(from), 0};
  best.loss = loss(best.at.x, best.at.y, std::numeric_limits<double>::max());
  double step_x = step;
  double step_y = step;
  std::size_t way = dice.below(kWays);
  std::array<double, kWays> signs{-1, -1, -1, -1};  // of each way, the one that has been better before
  while (best.loss > 0 && (step_x >= limit || step_y >= limit)) {
    const Position by{way == kAlongY ? 0 : step_x, way == kAlongX ? 0 : way == kFalling ? -step_y : step_y};
    const auto improve = [&](double sign) {
      const Position next = inside({best.at.x + sign * by.x, best.at.y + sign * by.y});
      if (next.x == best.at.x && next.y == best.at.y) return false;
      const double value = loss(next.x, next.y, best.loss);
      if (value >= best.loss) return false;
      best = {next, value};
      signs[way] = sign;
      return true;
    };
    const bool better = improve(signs[way]) || improve(-signs[way]);
    const double factor = better ? kLonger : kShorter;
    const double both = way == kRising || way == kFalling ? std::sqrt(factor) : factor;
    if (way != kAlongY) step_x *= both;
    if (way != kAlongX) step_y *= both;
    if (!better) way = (way + 1 + dice.below(kWays - 1)) % kWays;  // another one
  }
  return best;
}

}  // namespace selvage::nesting::local_search
