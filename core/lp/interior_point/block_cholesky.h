// The Cholesky factor of a sparse symmetric matrix in blocks of two by two, over and over with the same pattern.
//
// The columns of a piece, along x and along y, are held by the same rows, so what is sparse is the matrix of pieces;
// inside a block nothing is looked up.  Up-looking: row after row of the factor, each a sparse triangular solve
// [Dav06 4], with the pattern of every row worked out once.
// Blocks are stored column by column.  Invariant: block columns are in the order of elimination.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace selvage::lp::interior_point {

using Block = Eigen::Matrix2d;  // column by column

// Which blocks above the diagonal there are: those of block column k at start[k] up to start[k + 1], by ascending row.
struct BlockPattern {
  std::vector<int> start{0};
  std::vector<int> row;
  [[nodiscard]] std::size_t columns() const { return start.size() - 1; }
};

class BlockCholesky {
 public:
  explicit BlockCholesky(BlockPattern pattern);

  // Of the diagonal blocks the lower triangle is read.  False when the matrix is not positive definite in floating
  // point.
  [[nodiscard]] bool factorise(std::span<const Block> diagonal, std::span<const Block> above);
  // Solves in place; two entries to a block column.
  void solve(std::span<double> right_side) const;

 private:
  void find_rows();

  BlockPattern pattern_;
  std::vector<int> row_start_, row_;        // of the factor: the block columns of each row, ascending, no diagonal
  std::vector<int> column_start_, column_;  // the block rows of each column, ascending, no diagonal
  std::vector<Block> below_;                // the factor's blocks, column by column
  std::vector<Block> diagonal_;             // its diagonal blocks: 1/(0,0) (1,0) - 1/(1,1)
  std::vector<Block> work_;                 // a row of the factor on its way, transposed; 0 between rows
  std::vector<int> filled_;                 // how many blocks of each column are done
};

}  // namespace selvage::lp::interior_point
