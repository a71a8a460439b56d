#include "core/lp/elimination/elimination_order.h"

#include <algorithm>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace selvage::lp::elimination {

std::vector<int> elimination_order(const std::vector<Edge>& edges, int blocks, int last) {
  std::vector<Eigen::Triplet<char>> both;
  both.reserve(2 * edges.size() + static_cast<std::size_t>(blocks));
  for (int k = 0; k < blocks; ++k) both.emplace_back(k, k, 1);
  for (const auto& [a, b] : edges) {
    both.emplace_back(a, b, 1);
    both.emplace_back(b, a, 1);
  }
  Eigen::SparseMatrix<char> pattern(blocks, blocks);
  pattern.setFromTriplets(both.begin(), both.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> first;  // the block at each position
  Eigen::AMDOrdering<int>{}(pattern, first);
  std::vector<int> place(static_cast<std::size_t>(blocks));
  int next = 0;
  int next_last = last;
  for (int k = 0; k < blocks; ++k) {
    const int block = first.indices()[k];
    place[static_cast<std::size_t>(block)] = block < last ? next++ : next_last++;
  }
  return place;
}

BlockPattern pattern_of(std::vector<Edge> edges, const std::vector<int>& place) {
  for (auto& [a, b] : edges) {
    const auto [first, second] = std::minmax({place[static_cast<std::size_t>(a)], place[static_cast<std::size_t>(b)]});
    a = second;
    b = first;
  }
  std::sort(edges.begin(), edges.end());
  BlockPattern pattern;
  pattern.start.assign(place.size() + 1, 0);
  for (const auto& [column, row] : edges) {
    ++pattern.start[static_cast<std::size_t>(column) + 1];
    pattern.row.push_back(row);
  }
  for (std::size_t k = 0; k < place.size(); ++k) pattern.start[k + 1] += pattern.start[k];
  return pattern;
}

}  // namespace selvage::lp::elimination
