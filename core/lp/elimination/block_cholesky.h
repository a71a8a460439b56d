// The Cholesky factorisation of a sparse symmetric matrix in blocks of two by two, computed repeatedly with the same
// pattern.
//
// The x and y columns of a piece occur in the same rows, so the sparsity is that of a matrix over pieces, and no
// indices are needed inside a block.  The factorisation is up-looking: it computes the factor row by row, each row by a
// sparse triangular solve [Dav06 4].  The pattern of every row is computed once.
// Blocks are stored in column-major order.
// The last block columns may be kept: they are not eliminated, their Schur complement remains after the others have
// been, and both triangular solves skip them.
// Work is counted in block updates, each a product of two blocks.  A cancelled factorisation makes at most
// kUpdatesPerCheck more of them, and those of one row.
// Invariant: block columns are in elimination order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include <Eigen/Core>

namespace selvage::lp::elimination {

using Block = Eigen::Matrix2d;  // column-major

// The blocks above the diagonal: those of block column k are at start[k] up to start[k + 1], in ascending order of
// rows.
struct BlockPattern {
  std::vector<int> start{0};
  std::vector<int> row;
  [[nodiscard]] std::size_t columns() const { return start.size() - 1; }
};

class BlockCholesky {
 public:
  static constexpr std::uint64_t kUpdatesPerCheck = std::uint64_t{1} << 20;  // some milliseconds

  // Keeps the last `remaining` block columns.  REQUIRES: there are at least as many.
  explicit BlockCholesky(BlockPattern pattern, std::size_t remaining = 0);

  // Only the lower triangles of the diagonal blocks are read.  False when the matrix is not positive definite in
  // floating point, or when cancelled.
  [[nodiscard]] bool factorise(std::span<const Block> diagonal, std::span<const Block> above,
                               const std::stop_token& stop = {});
  // The block updates of the last factorisation.
  [[nodiscard]] std::uint64_t updates() const { return updates_; }
  // Solves in place; a block column has two entries.  REQUIRES: all block columns have been eliminated.
  void solve(std::span<double> right_side) const;
  // The two halves of that.  Between them the remaining entries have to be replaced with the solution of the remaining
  // matrix: solve_lower turns them into its right-hand side, and solve_upper takes them as known.
  void solve_lower(std::span<double> right_side) const;
  void solve_upper(std::span<double> right_side) const;

  // The block of the remaining matrix in a row and a column, row >= column; of a diagonal block, only the lower
  // triangle is meaningful.  Null where the matrix has no block.  Stays at its address.
  // REQUIRES: both are remaining block columns.
  [[nodiscard]] const Block* remaining(std::size_t row, std::size_t column) const;

 private:
  void find_rows();
  // Moves a row of the remaining matrix, except its diagonal block, from work_ to below_.
  void keep_row(std::size_t k);

  BlockPattern pattern_;
  std::size_t eliminated_;
  std::vector<int> row_start_, row_;  // the block columns of each row of the factor, ascending, without the diagonal
  std::vector<int> eliminated_end_;   // in row_, the end of each row's columns that are eliminated
  std::vector<int> column_start_,
      column_;  // the block rows of each column of the factor, ascending, without the diagonal
  // Of the eliminated columns: the factor's blocks below the diagonal, column by column, and its diagonal blocks
  // [a 0; b c], stored as 1/a, b and 1/c.  Of the others: the blocks of the remaining matrix.
  std::vector<Block> below_;
  std::vector<Block> diagonal_;
  std::vector<Block> work_;  // the row of the factor being computed, transposed; zero between rows
  std::vector<int> filled_;  // the number of finished blocks of each column
  std::uint64_t updates_{};
};

}  // namespace selvage::lp::elimination
