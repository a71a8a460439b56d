#include "core/lp/elimination/block_cholesky.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace selvage::lp::elimination {
namespace {

using Pair = Eigen::Vector2d;

// Multiplies v by the inverse of a diagonal block of the factor.
void divide_lower(const Block& diagonal, double& v0, double& v1) {
  v0 *= diagonal(0, 0);
  v1 = (v1 - diagonal(1, 0) * v0) * diagonal(1, 1);
}
// Multiplies v by the inverse of its transpose.
void divide_upper(const Block& diagonal, double& v0, double& v1) {
  v1 *= diagonal(1, 1);
  v0 = (v0 - diagonal(1, 0) * v1) * diagonal(0, 0);
}

// The index in a vector of a block column's first entry.
std::ptrdiff_t index_of(int block_column) {
  return 2 * static_cast<std::ptrdiff_t>(block_column);
}

// Replaces a symmetric block, given by its lower triangle, with its factor.
bool factorise_block(Block& block) {
  if (!(block(0, 0) > 0)) return false;
  const double first = 1 / std::sqrt(block(0, 0));
  const double below = block(1, 0) * first;
  const double left = block(1, 1) - below * below;
  if (!(left > 0)) return false;
  block << first, 0, below, 1 / std::sqrt(left);
  return true;
}

}  // namespace

BlockCholesky::BlockCholesky(BlockPattern pattern, std::size_t remaining)
    : pattern_{std::move(pattern)}, eliminated_{pattern_.columns() - remaining} {
  find_rows();
  const std::size_t size = pattern_.columns();
  column_start_.assign(size + 1, 0);
  for (const int i : row_) ++column_start_[static_cast<std::size_t>(i) + 1];
  for (std::size_t k = 0; k < size; ++k) column_start_[k + 1] += column_start_[k];
  column_.resize(row_.size());
  filled_.assign(size, 0);
  for (std::size_t k = 0; k < size; ++k) {
    for (int t = row_start_[k]; t < row_start_[k + 1]; ++t) {
      const auto i = static_cast<std::size_t>(row_[static_cast<std::size_t>(t)]);
      column_[static_cast<std::size_t>(column_start_[i]) + static_cast<std::size_t>(filled_[i]++)] =
          static_cast<int>(k);
    }
  }
  eliminated_end_.assign(row_start_.begin() + 1, row_start_.end());
  for (std::size_t k = eliminated_; k < size; ++k) {
    eliminated_end_[k] =
        static_cast<int>(std::lower_bound(row_.begin() + row_start_[k], row_.begin() + row_start_[k + 1],
                                          static_cast<int>(eliminated_)) -
                         row_.begin());
  }
  below_.resize(row_.size());
  diagonal_.resize(size);
  work_.assign(size, Block::Zero());
}

// Computes the pattern of each row of the factor, following the elimination tree upwards from the entries of the
// matrix's row [Dav06 4].
void BlockCholesky::find_rows() {
  constexpr int kNone = -1;
  const std::size_t size = pattern_.columns();
  std::vector<int> parent(size, kNone);
  std::vector<int> seen(size, kNone);
  row_start_.assign(1, 0);
  for (std::size_t k = 0; k < size; ++k) {
    const int row = static_cast<int>(k);
    seen[k] = row;
    for (int t = pattern_.start[k]; t < pattern_.start[k + 1]; ++t) {
      auto i = static_cast<std::size_t>(pattern_.row[static_cast<std::size_t>(t)]);
      while (seen[i] != row) {
        if (parent[i] == kNone) parent[i] = row;
        seen[i] = row;
        row_.push_back(static_cast<int>(i));
        i = static_cast<std::size_t>(parent[i]);
      }
    }
    std::sort(row_.begin() + row_start_.back(), row_.end());
    row_start_.push_back(static_cast<int>(row_.size()));
  }
}

bool BlockCholesky::factorise(std::span<const Block> diagonal, std::span<const Block> above,
                              const std::stop_token& stop) {
  std::fill(filled_.begin(), filled_.end(), 0);
  updates_ = 0;
  std::uint64_t next_check = kUpdatesPerCheck;
  Block* const work = work_.data();
  for (std::size_t k = 0; k < diagonal.size(); ++k) {
    if (updates_ >= next_check) {
      if (stop.stop_requested()) return false;
      next_check = updates_ + kUpdatesPerCheck;
    }
    for (int t = pattern_.start[k]; t < pattern_.start[k + 1]; ++t) {
      const auto e = static_cast<std::size_t>(t);
      work[pattern_.row[e]] = above[e];
    }
    Block own = diagonal[k];
    const int* const row_end = row_.data() + eliminated_end_[k];
    for (const int* row = row_.data() + row_start_[k]; row != row_end; ++row) {
      const auto i = static_cast<std::size_t>(*row);
      Block part = std::exchange(work[i], Block::Zero());  // becomes the transpose of the factor's block (k, i)
      divide_lower(diagonal_[i], part(0, 0), part(1, 0));
      divide_lower(diagonal_[i], part(0, 1), part(1, 1));
      const int* column = column_.data() + column_start_[i];
      const int* const end = column + filled_[i];
      updates_ += static_cast<std::uint64_t>(filled_[i]++) + 1;
      Block* below = below_.data() + column_start_[i];
      for (; column != end; ++column, ++below) {
        Block& to = work[*column];
        const Pair first = below->col(0);
        const Pair second = below->col(1);
        to.col(0) -= first * part(0, 0) + second * part(1, 0);
        to.col(1) -= first * part(0, 1) + second * part(1, 1);
      }
      own(0, 0) -= part(0, 0) * part(0, 0) + part(1, 0) * part(1, 0);
      own(1, 0) -= part(0, 1) * part(0, 0) + part(1, 1) * part(1, 0);
      own(1, 1) -= part(0, 1) * part(0, 1) + part(1, 1) * part(1, 1);
      *below = part.transpose();
    }
    if (k >= eliminated_) {
      keep_row(k);
    } else if (!factorise_block(own)) {
      return false;
    }
    diagonal_[k] = own;
  }
  return true;
}

void BlockCholesky::keep_row(std::size_t k) {
  for (int t = eliminated_end_[k]; t < row_start_[k + 1]; ++t) {
    const auto i = static_cast<std::size_t>(row_[static_cast<std::size_t>(t)]);
    below_[static_cast<std::size_t>(column_start_[i] + filled_[i]++)] =
        std::exchange(work_[i], Block::Zero()).transpose();
  }
}

const Block* BlockCholesky::remaining(std::size_t row, std::size_t column) const {
  if (row == column) return &diagonal_[row];
  const auto begin = column_.begin() + column_start_[column];
  const auto end = column_.begin() + column_start_[column + 1];
  const auto at = std::lower_bound(begin, end, static_cast<int>(row));
  return at != end && *at == static_cast<int>(row) ? &below_[static_cast<std::size_t>(at - column_.begin())] : nullptr;
}

void BlockCholesky::solve(std::span<double> right_side) const {
  solve_lower(right_side);
  solve_upper(right_side);
}

void BlockCholesky::solve_lower(std::span<double> right_side) const {
  using Place = Eigen::Map<Pair>;
  double* const v = right_side.data();
  for (std::size_t k = 0; k < eliminated_; ++k) {
    Place own{v + 2 * k};
    divide_lower(diagonal_[k], own[0], own[1]);
    const Pair known = own;
    const int* column = column_.data() + column_start_[k];
    const int* const end = column_.data() + column_start_[k + 1];
    const Block* below = below_.data() + column_start_[k];
    for (; column != end; ++column, ++below) {
      Place{v + index_of(*column)} -= below->col(0) * known[0] + below->col(1) * known[1];
    }
  }
}

void BlockCholesky::solve_upper(std::span<double> right_side) const {
  using Place = Eigen::Map<Pair>;
  double* const v = right_side.data();
  for (std::size_t k = eliminated_; k-- > 0;) {
    Place own{v + 2 * k};
    Pair left = own;
    const int* column = column_.data() + column_start_[k];
    const int* const end = column_.data() + column_start_[k + 1];
    const Block* below = below_.data() + column_start_[k];
    for (; column != end; ++column, ++below) {
      const Pair known = Place{v + index_of(*column)};
      // By rows of the transposed block, as the processor can add up pairs but not within a pair.
      left -= Pair{(*below)(0, 0), (*below)(0, 1)} * known[0] + Pair{(*below)(1, 0), (*below)(1, 1)} * known[1];
    }
    divide_upper(diagonal_[k], left[0], left[1]);
    own = left;
  }
}

}  // namespace selvage::lp::elimination
