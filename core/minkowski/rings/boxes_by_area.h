// Finds the boxes that touch or contain a window one after another by area, without looking at most of the others.
//
// The boxes are packed into a tree: sorted along x, cut into slices, and each slice sorted along y [LEL97].  Each box
// of the tree knows the largest and the smallest box below it, so a search that always follows the most promising one
// meets the boxes in the order of their areas. Units: lattice units.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/minkowski/rings/box_tree.h"

namespace selvage::minkowski::rings {

// The indices of the boxes by area, the largest first; of equal areas, the lower index comes first.
[[nodiscard]] std::vector<std::uint32_t> by_area(std::span<const Box> boxes);

class BoxesByArea {
 public:
  // `rank` is the place of each box in by_area(boxes).  REQUIRES: the boxes outlive this object.
  BoxesByArea(std::span<const Box> boxes, std::span<const std::uint32_t> rank);

  // Begins a search; next() returns the index of the first box, and then of each further one.
  void search_touching(const Box& window);    // the largest first
  void search_containing(const Box& window);  // the smallest first
  [[nodiscard]] std::optional<std::uint32_t> next();
  // Leaves a box out of all later searches.
  void leave_out(std::uint32_t box);

 private:
  // The ranks of the boxes below a node, those left out excepted.  Empty when least > most.
  struct Ranks {
    std::int64_t least{}, most{};
  };
  struct Node {
    std::int64_t priority{};
    std::uint32_t level{}, index{};
    friend bool operator<(const Node& a, const Node& b) { return a.priority < b.priority; }
  };
  [[nodiscard]] const Box& box(std::size_t level, std::size_t index) const {
    return level == 0 ? boxes_[leaf_[index]] : tree_.box(level, index);
  }
  [[nodiscard]] Ranks ranks_below(std::size_t level, std::size_t index) const;
  void search(const Box& window, bool containing);
  void push(std::size_t level, std::size_t index);

  std::span<const Box> boxes_;
  std::vector<std::uint32_t> leaf_;     // the box of each leaf of the tree
  std::vector<std::uint32_t> leaf_of_;  // the leaf of each box
  BoxTree tree_;
  std::vector<std::vector<Ranks>> ranks_;  // by level and index
  Box window_;
  bool containing_{};
  std::vector<Node> open_;  // a heap
};

}  // namespace selvage::minkowski::rings
