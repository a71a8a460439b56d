// A tree of bounding boxes over the edges of a sum, or over other things in a row, used to find those near a place. The
// first level has a box for every kFan consecutive edges, the next a box for every kFan consecutive boxes, and so on up
// to a single box.
// Units: lattice units.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/minkowski/convolution/star_sum.h"

namespace selvage::minkowski::rings {

[[nodiscard]] constexpr Box box_of(const convolution::SumEdge& edge) {
  return {{std::min(edge.from.x, edge.to.x), std::min(edge.from.y, edge.to.y)},
          {std::max(edge.from.x, edge.to.x), std::max(edge.from.y, edge.to.y)}};
}

class BoxTree {
 public:
  static constexpr std::size_t kFan = 4;

  BoxTree() = default;
  explicit BoxTree(std::span<const convolution::SumEdge> edges);
  explicit BoxTree(std::span<const Box> leaves);

  // The number of levels above the leaves.  Level 0 is the leaves, edges or boxes; the highest level is a single box
  // that contains all of them.  Without leaves there is only level 0.
  [[nodiscard]] std::size_t levels() const { return level_start_.size() - 1; }
  // REQUIRES: 1 <= level <= levels().
  [[nodiscard]] const Box& box(std::size_t level, std::size_t index) const {
    return boxes_[level_start_[level - 1] + index];
  }
  // One past the last child, on `level`, of box `index` of the level above; its first child is index * kFan.
  [[nodiscard]] std::size_t end_of_run(std::size_t level, std::size_t index) const {
    return std::min(size(level), (index + 1) * kFan);
  }
  [[nodiscard]] std::size_t bytes() const {
    return boxes_.capacity() * sizeof(Box) + level_start_.capacity() * sizeof(std::size_t);
  }

 private:
  template <class BoxOf>
  void build(BoxOf box_of_leaf);
  [[nodiscard]] std::size_t size(std::size_t level) const {
    return level == 0 ? leaves_ : level_start_[level] - level_start_[level - 1];
  }

  std::size_t leaves_{};
  std::vector<Box> boxes_;                   // level by level, starting with level 1
  std::vector<std::size_t> level_start_{0};  // start of each level in `boxes_`, and the end
};

}  // namespace selvage::minkowski::rings
