#include "core/minkowski/box_tree.h"

namespace selvage::minkowski {

BoxTree::BoxTree(std::span<const convolution::SumEdge> edges) : edges_{edges.size()} {
  if (edges.empty()) return;
  std::size_t below = edges.size();
  do {
    below = (below + kFan - 1) / kFan;
    level_start_.push_back(level_start_.back() + below);
  } while (below > 1);
  boxes_.reserve(level_start_.back());
  for (std::size_t level = 1; level <= levels(); ++level) {
    const auto box_below = [&](std::size_t k) { return level == 1 ? box_of(edges[k]) : box(level - 1, k); };
    for (std::size_t k = 0; k < size(level - 1); k += kFan) {
      Box all = box_below(k);
      for (std::size_t m = k + 1; m < end_of_run(level - 1, k / kFan); ++m) all = united(all, box_below(m));
      boxes_.push_back(all);
    }
  }
}

}  // namespace selvage::minkowski
