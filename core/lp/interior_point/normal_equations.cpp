#include "core/lp/interior_point/normal_equations.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/lp/elimination/block_cholesky.h"
#include "core/lp/elimination/elimination_order.h"

namespace selvage::lp::interior_point {
namespace {

using elimination::Block;
using elimination::BlockPattern;
using elimination::Edge;

// The position of a column: its block column, and its offset (0 or 1) within the block.
struct Slot {
  int block{}, offset{};
};

std::span<const RowRuns::Difference> differences_of(const RowRuns& rows, const RowRuns::Run& run) {
  return std::span{rows.differences}.subspan(static_cast<std::size_t>(run.first_difference),
                                             static_cast<std::size_t>(run.width));
}

// Consecutive columns that occur in the same rows, such as those of a piece, share a block.  Any other column has a
// block of its own, whose second place stays empty.  No block has columns on both sides of `own`.  The last slot is
// that of the zero column.
std::vector<Slot> slots_of(const RowRuns& rows, int own) {
  const auto size = static_cast<std::size_t>(rows.columns);
  std::vector<char> with_next(size + 1);
  for (const RowRuns::Run& run : rows.runs) {
    const auto of = differences_of(rows, run);
    for (std::size_t k = 0; k + 1 < of.size(); ++k) {
      if (of[k + 1].plus == of[k].plus + 1) with_next[static_cast<std::size_t>(of[k].plus)] = 1;
      if (of[k + 1].minus == of[k].minus + 1) with_next[static_cast<std::size_t>(of[k].minus)] = 1;
    }
  }
  if (own > 0) with_next[static_cast<std::size_t>(own) - 1] = 0;
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

}  // namespace

struct NormalEquations::Parts {
  Parts(const RowRuns& r, int o) : rows{r}, own{static_cast<std::size_t>(o)} {}
  void find_positions(const BlockPattern& pattern);
  // The index of a column's entry in `ordered`.
  [[nodiscard]] std::size_t place(std::size_t column) const {
    return 2 * static_cast<std::size_t>(slots[column].block) + static_cast<std::size_t>(slots[column].offset);
  }

  const RowRuns& rows;
  const std::size_t own;
  std::vector<Slot> slots;  // by column; blocks are numbered in elimination order
  std::size_t blocks{}, own_blocks{};
  // The diagonal blocks, the blocks above the diagonal, and one block that collects what falls on the zero column.
  std::vector<Block> matrix;
  std::vector<int> position;  // the index in `matrix` of each number of the runs' products, then of the bounds'
  std::optional<elimination::BlockCholesky> factor;
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

NormalEquations::NormalEquations(const RowRuns& rows, int own) : parts_{std::make_unique<Parts>(rows, own)} {
  Parts& p = *parts_;
  p.slots = slots_of(rows, own);
  const int blocks = p.slots.back().block;
  const int own_blocks = p.slots[p.own].block;
  p.blocks = static_cast<std::size_t>(blocks);
  p.own_blocks = static_cast<std::size_t>(own_blocks);
  const std::vector<Edge> edges = edges_of(rows, p.slots);
  const std::vector<int> place = elimination::elimination_order(edges, blocks, own_blocks);
  for (std::size_t j = 0; j + 1 < p.slots.size(); ++j) {
    p.slots[j].block = place[static_cast<std::size_t>(p.slots[j].block)];
  }
  BlockPattern pattern = elimination::pattern_of(edges, place);
  p.matrix.resize(p.blocks + pattern.row.size() + 1);
  p.find_positions(pattern);
  p.factor.emplace(std::move(pattern), p.blocks - p.own_blocks);
  p.ordered.resize(2 * p.blocks);
}

NormalEquations::~NormalEquations() = default;

bool NormalEquations::factorise(std::span<const double> weight, double rho, const std::stop_token& stop) {
  Parts& p = *parts_;
  const auto above = p.matrix.begin() + static_cast<std::ptrdiff_t>(p.blocks);
  const auto left = p.matrix.begin() + static_cast<std::ptrdiff_t>(p.own_blocks);
  std::fill(p.matrix.begin(), left, rho * Block::Identity());
  std::fill(left, above, Block::Zero());
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

void NormalEquations::solve_lower(std::span<double> right_side) {
  Parts& p = *parts_;
  std::fill(p.ordered.begin(), p.ordered.end(), 0.0);
  const auto columns = static_cast<std::size_t>(p.rows.columns);
  for (std::size_t j = 0; j < columns; ++j) p.ordered[p.place(j)] = right_side[j];
  p.factor->solve_lower(p.ordered);
  for (std::size_t j = p.own; j < columns; ++j) right_side[j] = p.ordered[p.place(j)];
}

void NormalEquations::solve_upper(std::span<double> right_side) {
  Parts& p = *parts_;
  const auto columns = static_cast<std::size_t>(p.rows.columns);
  for (std::size_t j = p.own; j < columns; ++j) p.ordered[p.place(j)] = right_side[j];
  p.factor->solve_upper(p.ordered);
  for (std::size_t j = 0; j < p.own; ++j) right_side[j] = p.ordered[p.place(j)];
}

const double* NormalEquations::remaining(int i, int j) const {
  Slot row = parts_->slots[static_cast<std::size_t>(i)];
  Slot column = parts_->slots[static_cast<std::size_t>(j)];
  if (std::pair{row.block, row.offset} < std::pair{column.block, column.offset}) std::swap(row, column);
  const Block* block =
      parts_->factor->remaining(static_cast<std::size_t>(row.block), static_cast<std::size_t>(column.block));
  return block == nullptr ? nullptr : block->data() + row.offset + std::ptrdiff_t{2} * column.offset;
}

}  // namespace selvage::lp::interior_point
