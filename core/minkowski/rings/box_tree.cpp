#include "core/minkowski/rings/box_tree.h"

namespace selvage::minkowski::rings {

template <class BoxOf>
void BoxTree::build(BoxOf box_of_leaf) {
  if (leaves_ == 0) return;
  std::size_t below = leaves_;
  do {
    below = (below + kFan - 1) / kFan;
    level_start_.push_back(level_start_.back() + below);
  } while (below > 1);
  boxes_.reserve(level_start_.back());
  for (std::size_t level = 1; level <= levels(); ++level) {
    const auto box_below = [&](std::size_t k) { return level == 1 ? box_of_leaf(k) : box(level - 1, k); };
    for (std::size_t k = 0; k < size(level - 1); k += kFan) {
      Box all = box_below(k);
      for (std::size_t m = k + 1; m < end_of_run(level - 1, k / kFan); ++m) all = united(all, box_below(m));
      boxes_.push_back(all);
    }
  }
}

BoxTree::BoxTree(std::span<const convolution::SumEdge> edges) : leaves_{edges.size()} {
  build([&](std::size_t k) { return box_of(edges[k]); });
}

BoxTree::BoxTree(std::span<const Box> leaves) : leaves_{leaves.size()} {
  build([&](std::size_t k) { return leaves[k]; });
}

}  // namespace selvage::minkowski::rings
