#include "core/lp/block_cholesky.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace selvage {
namespace {

// The inverse of the lower triangle of a factor's diagonal block, times v.
void solve_lower(const Block& diagonal, double& v0, double& v1) {
  v0 *= diagonal[0];
  v1 = (v1 - diagonal[1] * v0) * diagonal[3];
}
// The same for its transpose.
void solve_upper(const Block& diagonal, double& v0, double& v1) {
  v1 *= diagonal[3];
  v0 = (v0 - diagonal[1] * v1) * diagonal[0];
}

// to -= a b.
void subtract_product(Block& to, const Block& a, const Block& b) {
  to = {to[0] - (a[0] * b[0] + a[2] * b[1]), to[1] - (a[1] * b[0] + a[3] * b[1]), to[2] - (a[0] * b[2] + a[2] * b[3]),
        to[3] - (a[1] * b[2] + a[3] * b[3])};
}

// Turns a symmetric block, of which the lower triangle is read, into its factor.
bool factorise_block(Block& block) {
  if (!(block[0] > 0)) return false;
  const double first = 1 / std::sqrt(block[0]);
  const double below = block[1] * first;
  const double left = block[3] - below * below;
  if (!(left > 0)) return false;
  block = {first, below, 0, 1 / std::sqrt(left)};
  return true;
}

}  // namespace

BlockCholesky::BlockCholesky(BlockPattern pattern) : pattern_{std::move(pattern)} {
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
      column_[static_cast<std::size_t>(column_start_[i] + filled_[i]++)] = static_cast<int>(k);
    }
  }
  below_.resize(row_.size());
  diagonal_.resize(size);
  work_.resize(size);
}

// The pattern of each row of the factor: from the entries of the matrix's row up the elimination tree [Dav06 4].
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

bool BlockCholesky::factorise(std::span<const Block> diagonal, std::span<const Block> above) {
  std::fill(filled_.begin(), filled_.end(), 0);
  std::fill(work_.begin(), work_.end(), Block{});
  for (std::size_t k = 0; k < diagonal.size(); ++k) {
    for (int t = pattern_.start[k]; t < pattern_.start[k + 1]; ++t) {
      const auto e = static_cast<std::size_t>(t);
      work_[static_cast<std::size_t>(pattern_.row[e])] = above[e];
    }
    Block own = diagonal[k];
    for (int t = row_start_[k]; t < row_start_[k + 1]; ++t) {
      const auto i = static_cast<std::size_t>(row_[static_cast<std::size_t>(t)]);
      Block part = std::exchange(work_[i], Block{});  // becomes the transpose of the factor's block (k, i)
      solve_lower(diagonal_[i], part[0], part[1]);
      solve_lower(diagonal_[i], part[2], part[3]);
      const int begin = column_start_[i];
      const int end = begin + filled_[i]++;
      for (int p = begin; p < end; ++p) {
        const auto e = static_cast<std::size_t>(p);
        subtract_product(work_[static_cast<std::size_t>(column_[e])], below_[e], part);
      }
      own[0] -= part[0] * part[0] + part[1] * part[1];
      own[1] -= part[2] * part[0] + part[3] * part[1];
      own[3] -= part[2] * part[2] + part[3] * part[3];
      below_[static_cast<std::size_t>(end)] = {part[0], part[2], part[1], part[3]};
    }
    if (!factorise_block(own)) return false;
    diagonal_[k] = own;
  }
  return true;
}

void BlockCholesky::solve(std::span<double> right_side) const {
  double* v = right_side.data();
  const std::size_t size = pattern_.columns();
  for (std::size_t k = 0; k < size; ++k) {
    double v0 = v[2 * k];
    double v1 = v[2 * k + 1];
    solve_lower(diagonal_[k], v0, v1);
    v[2 * k] = v0;
    v[2 * k + 1] = v1;
    for (int p = column_start_[k]; p < column_start_[k + 1]; ++p) {
      const Block& block = below_[static_cast<std::size_t>(p)];
      double* to = v + 2 * static_cast<std::size_t>(column_[static_cast<std::size_t>(p)]);
      to[0] -= block[0] * v0 + block[2] * v1;
      to[1] -= block[1] * v0 + block[3] * v1;
    }
  }
  for (std::size_t k = size; k-- > 0;) {
    double v0 = v[2 * k];
    double v1 = v[2 * k + 1];
    for (int p = column_start_[k]; p < column_start_[k + 1]; ++p) {
      const Block& block = below_[static_cast<std::size_t>(p)];
      const double* from = v + 2 * static_cast<std::size_t>(column_[static_cast<std::size_t>(p)]);
      v0 -= block[0] * from[0] + block[1] * from[1];
      v1 -= block[2] * from[0] + block[3] * from[1];
    }
    solve_upper(diagonal_[k], v0, v1);
    v[2 * k] = v0;
    v[2 * k + 1] = v1;
  }
}

}  // namespace selvage
