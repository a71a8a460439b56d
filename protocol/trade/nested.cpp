#include "protocol/trade/nested.h"

#include <algorithm>
#include <cmath>

namespace selvage::protocol::trade {

using document::Spot;

std::vector<NestedLoop> nested(std::vector<Loop> loops) {
  std::erase_if(loops, [](const Loop& loop) { return !(std::abs(doubled_area(loop.points)) > 0); });
  std::stable_sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
    return std::abs(doubled_area(a.points)) > std::abs(doubled_area(b.points));
  });
  std::vector<NestedLoop> outer;
  for (Loop& loop : loops) {
    NestedLoop* const around = around_of(outer, loop.points);
    if (around) {
      around->inner.push_back(std::move(loop));
      continue;
    }
    NestedLoop one;
    one.low = one.high = loop.points.front();
    for (const Spot& p : loop.points) {
      one.low = {std::min(one.low.x, p.x), std::min(one.low.y, p.y)};
      one.high = {std::max(one.high.x, p.x), std::max(one.high.y, p.y)};
    }
    one.loop = std::move(loop);
    outer.push_back(std::move(one));
  }
  return outer;
}

NestedLoop* around_of(std::vector<NestedLoop>& outer, const std::vector<Spot>& points) {
  if (points.empty()) return nullptr;
  const Spot first = points.front(), last = points.back(), middle = points[points.size() / 2];
  const auto found = std::find_if(outer.begin(), outer.end(), [&](const NestedLoop& one) {
    const auto in_box = [&](Spot p) {
      return p.x >= one.low.x && p.x <= one.high.x && p.y >= one.low.y && p.y <= one.high.y;
    };
    if (!in_box(first) && !in_box(last) && !in_box(middle)) return false;
    const auto inside =
        std::count_if(points.begin(), points.end(), [&](Spot p) { return contains(one.loop.points, p); });
    return 2 * static_cast<std::size_t>(inside) > points.size();
  });
  return found == outer.end() ? nullptr : &*found;
}

}  // namespace selvage::protocol::trade
