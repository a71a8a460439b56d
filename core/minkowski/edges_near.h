// A sum's edges near a box, by the sum's tree of boxes.
#pragma once

#include <algorithm>

#include "core/minkowski/sum.h"

namespace selvage {

[[nodiscard]] constexpr Box box_of(const SumEdge& edge) {
  return {{std::min(edge.from.x, edge.to.x), std::min(edge.from.y, edge.to.y)},
          {std::max(edge.from.x, edge.to.x), std::max(edge.from.y, edge.to.y)}};
}

// Calls visit(edge) for every edge whose box touches `window`; in the order of the edges.
template <class Visit>
void for_each_edge_near(const MinkowskiSum& sum, const Box& window, Visit visit) {
  const auto tree = sum.tree();
  const auto edges = sum.edges();
  const auto descend = [&](const auto& self, std::size_t level, std::size_t index) -> void {
    if (level == 0) {
      if (box_of(edges[index]).touches(window)) visit(edges[index]);
      return;
    }
    if (!tree[level - 1][index].touches(window)) return;
    const std::size_t below = level == 1 ? edges.size() : tree[level - 2].size();
    const std::size_t first = index * MinkowskiSum::kFan;
    for (std::size_t k = first; k < std::min(below, first + MinkowskiSum::kFan); ++k) self(self, level - 1, k);
  };
  if (!edges.empty()) descend(descend, tree.size(), 0);
}

}  // namespace selvage
