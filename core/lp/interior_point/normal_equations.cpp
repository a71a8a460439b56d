#include "core/lp/interior_point/normal_equations.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include "core/lp/interior_point/block_cholesky.h"

namespace selvage::lp::interior_point {
namespace {

using Edge = std::pair<int, int>;

// The position of a column: its block column, and its offset (0 or 1) within the block.
struct Slot {
  int block{}, offset{};
};

std::span<const RowRuns::Difference> differences_of(const RowRuns& rows, const RowRuns::Run& run) {
  return std::span{rows.differences}.subspan(static_cast<std::size_t>(run.first_difference),
                                             static_cast<std::size_t>(run.width));
}

// Consecutive columns that occur in the same rows, such as those of a piece, share a block.  Any other column has a
// block of its own, whose second place stays empty.  The last slot is that of the zero column.
std::vector<Slot> slots_of(const RowRuns& rows) {
  const auto size = static_cast<std::size_t>(rows.columns);
  std::vector<char> with_next(size + 1);
  for (const RowRuns::Run& run : rows.runs) {
    const auto of = differences_of(rows, run);
    for (std::size_t k = 0; k + 1 < of.size(); ++k) {
      if (of[k + 1].plus == of[k].plus + 1) with_next[static_cast<std::size_t>(of[k].plus)] = 1;
      if (of[k + 1].minus == of[k].minus + 1) with_next[static_cast<std::size_t>(of[k].minus)] = 1;
    }
  }
  std::vector<Slot> slots(size + 1);
  int block = 0;
  for (std::size_t j = 0; j < size; ++j, ++block) {
    slots[j] = {block, 0};
    if (with_next[j] != 0 && j + 1 < size) slots[++j] = {block, 1};
  }
  slots[size] = {block, 0};
  return slots;
}

// The pairs of blocks that occur in a common row, the smaller first; each pair once, and without the zero column.
std::vector<Edge> edges_of(const RowRuns& rows, const std::vector<Slot>& slots) {
  std::vector<Edge> edges;
  std::vector<int> blocks;
  for (const RowRuns::Run& run : rows.runs) {
    blocks.clear();
    for (const auto& [plus, minus] : differences_of(rows, run)) {
      for (const int column : {plus, minus}) {
        const int block = slots[static_cast<std::size_t>(column)].block;
        if (column != rows.zero_column() && std::find(blocks.begin(), blocks.end(), block) == blocks.end()) {
          blocks.push_back(block);
        }
      }
    }
    for (std::size_t a = 0; a < blocks.size(); ++a) {
      for (std::size_t b = a + 1; b < blocks.size(); ++b) edges.push_back(std::minmax({blocks[a], blocks[b]}));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// The position of each block in an elimination order with little fill (approximate minimum degree).
std::vector<int> elimination_order(const std::vector<Edge>& edges, int blocks) {
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
  for (int k = 0; k < blocks; ++k) place[static_cast<std::size_t>(first.indices()[k])] = k;
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

}  // namespace

struct NormalEquations::Parts {
  explicit Parts(const RowRuns& r) : rows{r} {}
  void find_positions(const BlockPattern& pattern);

  const RowRuns& rows;
  std::vector<Slot> slots;  // by column; blocks are numbered in elimination order
  std::size_t blocks{};
  // The diagonal blocks, the blocks above the diagonal, and one block that collects what falls on the zero column.
  std::vector<Block> matrix;
  std::vector<int> position;  // the index in `matrix` of each number of the runs' products, then of the bounds'
  std::optional<BlockCholesky> factor;
  std::vector<double> ordered;  // a right-hand side in elimination order
};

// The product of two differences contributes to four entries, that of a difference with itself to three.
void NormalEquations::Parts::find_positions(const BlockPattern& pattern) {
  const int discarded = 4 * static_cast<int>(matrix.size() - 1);
  const auto find = [&](int i, int j) {
    if (i == rows.zero_column() || j == rows.zero_column()) return discarded;
    auto [first, second] = std::pair{slots[static_cast<std::size_t>(i)], slots[static_cast<std::size_t>(j)]};
    if (first.block == second.block) return 4 * first.block + (i == j ? 3 * first.offset : 1);
    if (first.block > second.block) std::swap(first, second);
    const auto begin = pattern.row.begin() + pattern.start[static_cast<std::size_t>(second.block)];
    const auto end = pattern.row.begin() + pattern.start[static_cast<std::size_t>(second.block) + 1];
    const auto above = std::lower_bound(begin, end, first.block) - pattern.row.begin();
    return 4 * static_cast<int>(blocks + static_cast<std::size_t>(above)) + first.offset + 2 * second.offset;
  };
  for (const RowRuns::Run& run : rows.runs) {
    const auto of = differences_of(rows, run);
    for (std::size_t a = 0; a < of.size(); ++a) {
      for (std::size_t b = a; b < of.size(); ++b) {
        position.push_back(find(of[a].plus, of[b].plus));
        position.push_back(find(of[a].minus, of[b].minus));
        position.push_back(find(of[a].plus, of[b].minus));
        if (a != b) position.push_back(find(of[a].minus, of[b].plus));
      }
    }
  }
  for (const RowRuns::Bound& bound : rows.bounds) position.push_back(find(bound.column, bound.column));
}

NormalEquations::NormalEquations(const RowRuns& rows) : parts_{std::make_unique<Parts>(rows)} {
  Parts& p = *parts_;
  p.slots = slots_of(rows);
  const int blocks = p.slots.back().block;
  p.blocks = static_cast<std::size_t>(blocks);
  const std::vector<Edge> edges = edges_of(rows, p.slots);
  const std::vector<int> place = elimination_order(edges, blocks);
  for (std::size_t j = 0; j + 1 < p.slots.size(); ++j) {
    p.slots[j].block = place[static_cast<std::size_t>(p.slots[j].block)];
  }
  BlockPattern pattern = pattern_of(edges, place);
  p.matrix.resize(p.blocks + pattern.row.size() + 1);
  p.find_positions(pattern);
  p.factor.emplace(std::move(pattern));
  p.ordered.resize(2 * p.blocks);
}

NormalEquations::~NormalEquations() = default;

bool NormalEquations::factorise(std::span<const double> weight, double rho, const std::stop_token& stop) {
  Parts& p = *parts_;
  const auto above = p.matrix.begin() + static_cast<std::ptrdiff_t>(p.blocks);
  std::fill(p.matrix.begin(), above, rho * Block::Identity());
  std::fill(above, p.matrix.end(), Block::Zero());
  double* matrix = p.matrix.front().data();
  const int* position = p.position.data();
  for (const RowRuns::Run& run : p.rows.runs) {
    for_weighted_products(p.rows, run, weight, [&](int a, int b, double sum) {
      matrix[*position++] += sum;
      matrix[*position++] += sum;
      matrix[*position++] -= sum;
      if (a != b) matrix[*position++] -= sum;
    });
  }
  const double* w = weight.data() + weight.size() - p.rows.bounds.size();
  for (std::size_t k = 0; k < p.rows.bounds.size(); ++k) matrix[*position++] += w[k];
  return p.factor->factorise({p.matrix.begin(), above}, {above, p.matrix.end() - 1}, stop);
}

void NormalEquations::solve(std::span<double> right_side) {
  Parts& p = *parts_;
  std::fill(p.ordered.begin(), p.ordered.end(), 0.0);
  const auto place = [&](std::size_t j) {
    return 2 * static_cast<std::size_t>(p.slots[j].block) + static_cast<std::size_t>(p.slots[j].offset);
  };
  const auto columns = static_cast<std::size_t>(p.rows.columns);
  for (std::size_t j = 0; j < columns; ++j) p.ordered[place(j)] = right_side[j];
  p.factor->solve(p.ordered);
  for (std::size_t j = 0; j < columns; ++j) right_side[j] = p.ordered[place(j)];
}

}  // namespace selvage::lp::interior_point
