// The normal equations of the columns that several domains share (division.h): what remains of each domain's equations
// after its own columns have been eliminated adds up to a matrix over the border, the Schur complement of the whole.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/lp/elimination/block_cholesky.h"
#include "core/lp/interior_point/normal_equations.h"

namespace selvage::lp::interior_point {

class Border {
 public:
  struct Member {
    const NormalEquations* normal{};  // outlives the border
    int own{};                        // the first column that it keeps
    std::span<const int> border;      // of each kept column, its index in the border
  };
  // `columns`: the program's, ascending; a program that is not divided has none.
  Border(std::span<const int> columns, std::span<const Member> members);

  // Adds up what remains of the members' matrices, in their order, and rho on the diagonal.
  // False when the matrix is not positive definite in floating point, or when cancelled.
  [[nodiscard]] bool factorise(double rho, const std::stop_token& stop);
  // Solves in place; an entry for each column of the border.
  void solve(std::span<double> right_side);

 private:
  struct Transfer {
    const double* from{};
    std::size_t to{};  // in matrix_, number by number
  };
  std::vector<std::size_t> place_;          // of each column in elimination order; a block has two places
  std::vector<elimination::Block> matrix_;  // the diagonal blocks, then those above the diagonal
  std::size_t blocks_{};
  std::vector<Transfer> transfers_;
  elimination::BlockCholesky factor_;
  std::vector<double> ordered_;
};

}  // namespace selvage::lp::interior_point
