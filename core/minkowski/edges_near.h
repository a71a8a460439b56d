// Enumerates a sum's edges near a box, using the sum's box tree.
#pragma once

#include "core/minkowski/sum.h"

namespace selvage::minkowski {

// Calls visit(edge) for every edge whose box touches `window`, in the order of the edges.
template <class Visit>
void for_each_edge_near(const MinkowskiSum& sum, const Box& window, Visit visit) {
  const rings::BoxTree& tree = sum.tree();
  const auto edges = sum.edges();
  const auto descend = [&](const auto& self, std::size_t level, std::size_t index) -> void {
    if (level == 0) {
      if (rings::box_of(edges[index]).touches(window)) visit(edges[index]);
      return;
    }
    if (!tree.box(level, index).touches(window)) return;
    const std::size_t end = tree.end_of_run(level - 1, index);
    for (std::size_t k = index * rings::BoxTree::kFan; k < end; ++k) self(self, level - 1, k);
  };
  if (!edges.empty()) descend(descend, tree.levels(), 0);
}

}  // namespace selvage::minkowski
