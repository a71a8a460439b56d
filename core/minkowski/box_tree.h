// A tree of boxes over the edges of a sum, by which those near a place are found: boxes over runs of kFan edges, then
// over runs of kFan boxes, and so on up to a single one.  Units: lattice units.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/minkowski/convolution/star_sum.h"

namespace selvage::minkowski {

[[nodiscard]] constexpr Box box_of(const convolution::SumEdge& edge) {
  return {{std::min(edge.from.x, edge.to.x), std::min(edge.from.y, edge.to.y)},
          {std::max(edge.from.x, edge.to.x), std::max(edge.from.y, edge.to.y)}};
}

class BoxTree {
 public:
  static constexpr std::size_t kFan = 4;

  BoxTree() = default;
  explicit BoxTree(std::span<const convolution::SumEdge> edges);

  // Level 0 is the edges themselves, on the highest level is one box: of all; without edges there is level 0 only.
  [[nodiscard]] std::size_t levels() const { return level_start_.size() - 1; }
  // REQUIRES: 1 <= level <= levels().
  [[nodiscard]] const Box& box(std::size_t level, std::size_t index) const {
    return boxes_[level_start_[level - 1] + index];
  }
  // What a box of the level above is over: those from index * kFan up to this.
  [[nodiscard]] std::size_t end_of_run(std::size_t level, std::size_t index) const {
    return std::min(size(level), (index + 1) * kFan);
  }
  [[nodiscard]] std::size_t bytes() const {
    return boxes_.capacity() * sizeof(Box) + level_start_.capacity() * sizeof(std::size_t);
  }

 private:
  [[nodiscard]] std::size_t size(std::size_t level) const {
    return level == 0 ? edges_ : level_start_[level] - level_start_[level - 1];
  }

  std::size_t edges_{};
  std::vector<Box> boxes_;                   // level by level, from the first up
  std::vector<std::size_t> level_start_{0};  // and one past the last
};

}  // namespace selvage::minkowski
