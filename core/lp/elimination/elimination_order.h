// Elimination orders with little fill, and the pattern of a matrix in such an order.
#pragma once

#include <utility>
#include <vector>

#include "core/lp/elimination/block_cholesky.h"

namespace selvage::lp::elimination {

using Edge = std::pair<int, int>;

// The position of each block in an order with little fill, by approximate minimum degree [ADD96].  The blocks from
// `last` on are eliminated after all others.
[[nodiscard]] std::vector<int> elimination_order(const std::vector<Edge>& edges, int blocks, int last);

// The pattern of a matrix with a block for each edge, in that order.
// REQUIRES: no edge occurs twice.
[[nodiscard]] BlockPattern pattern_of(std::vector<Edge> edges, const std::vector<int>& place);

}  // namespace selvage::lp::elimination
