// Enumerates a sum's edges in the order of their distance from a point, by a best-first search of the sum's box tree.
// Units: lattice units.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <boost/container/small_vector.hpp>

#include "core/minkowski/sum.h"

namespace selvage::minkowski {

class NearestEdges {
 public:
  struct Near {
    const convolution::SumEdge* edge{};
    double squared_distance{};  // from the point to the edge; lattice units squared
  };

  // Edges farther than `reach` from the point `from` are left out.
  NearestEdges(const MinkowskiSum& sum, Vec from, double reach);

  // The next edge; nothing when there are no more.  `skip(box)` returns true when the edges inside the box can be left
  // out.
  template <class Skip>
  std::optional<Near> next(Skip skip);

 private:
  static constexpr std::size_t kUsual = 32;  // inline capacity of the heap, in nodes; few sums need more

  struct Node {
    double squared_distance{};
    std::uint32_t level{};  // 0: an edge; k: a box on level k
    std::uint32_t index{};
  };
  static bool farther(const Node& a, const Node& b) {
    if (a.squared_distance != b.squared_distance) return a.squared_distance > b.squared_distance;
    return a.level != b.level ? a.level < b.level : a.index > b.index;
  }
  void push(std::uint32_t level, std::size_t index);
  [[nodiscard]] double squared_distance(const Box& box) const;
  [[nodiscard]] double squared_distance(const convolution::SumEdge& edge) const;

  const MinkowskiSum& sum_;
  Vec from_;
  double squared_reach_;
  boost::container::small_vector<Node, kUsual> heap_;
};

// The point of the sum's boundary nearest to `from`, and its distance.  When the sum has no visible edge, the distance
// is infinite and `edge` is null.
struct BoundaryPoint {
  RealVec at;
  double distance{};
  const convolution::SumEdge* edge{};
};
[[nodiscard]] BoundaryPoint nearest_boundary_point(const MinkowskiSum& sum, Vec from);

template <class Skip>
std::optional<NearestEdges::Near> NearestEdges::next(Skip skip) {
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), farther);
    const Node node = heap_.back();
    heap_.pop_back();
    if (node.level == 0) return Near{&sum_.edges()[node.index], node.squared_distance};
    const rings::BoxTree& tree = sum_.tree();
    if (skip(tree.box(node.level, node.index))) continue;
    const std::size_t end = tree.end_of_run(node.level - 1, node.index);
    for (std::size_t k = node.index * rings::BoxTree::kFan; k < end; ++k) push(node.level - 1, k);
  }
  return std::nullopt;
}

}  // namespace selvage::minkowski
