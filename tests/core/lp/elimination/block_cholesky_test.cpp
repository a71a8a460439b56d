// The factorisation of small matrices, and of one so large that it is cancelled on the way.
#include "core/lp/elimination/block_cholesky.h"

#include <gtest/gtest.h>

#include <limits>
#include <stop_token>
#include <vector>

#include <Eigen/LU>

namespace selvage::lp::elimination {
namespace {

TEST(BlockCholesky, RejectsIndefiniteMatricesAndStaysUsable) {
  BlockPattern pattern;
  pattern.start = {0, 0, 1};
  pattern.row = {0};
  BlockCholesky factor{pattern};
  const Block one = Block::Identity();
  const std::vector<Block> above{one};
  EXPECT_FALSE(factor.factorise(std::vector<Block>{one, one}, above));                    // singular
  EXPECT_FALSE(factor.factorise(std::vector<Block>{Block{{1, 0}, {2, 1}}, one}, above));  // indefinite within a block
  EXPECT_FALSE(factor.factorise(std::vector<Block>{Block{{-1, 0}, {0, 1}}, one}, above));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(factor.factorise(std::vector<Block>{Block{{nan, 0}, {0, 1}}, one}, above));
  ASSERT_TRUE(factor.factorise(std::vector<Block>{one, 2 * one}, above));
  std::vector<double> v{3, 4, 5, 6};  // (1 1; 1 2) (x; y) in both blocks
  factor.solve(v);
  EXPECT_NEAR(v[0], 1, 1e-14);
  EXPECT_NEAR(v[1], 2, 1e-14);
  EXPECT_NEAR(v[2], 2, 1e-14);
  EXPECT_NEAR(v[3], 2, 1e-14);
}

// A full matrix of `size` block columns: 4 times the unit matrix in every block on the diagonal, a little elsewhere.
struct FullMatrix {
  BlockPattern pattern;
  std::vector<Block> diagonal, above;
};
FullMatrix full_matrix(int size) {
  FullMatrix full;
  for (int k = 0; k < size; ++k) {
    for (int i = 0; i < k; ++i) full.pattern.row.push_back(i);
    full.pattern.start.push_back(static_cast<int>(full.pattern.row.size()));
    full.diagonal.emplace_back(4 * Block::Identity());
  }
  full.above.assign(full.pattern.row.size(), 1e-3 * Block::Identity());
  return full;
}

TEST(BlockCholesky, StopsWithinTheWorkBetweenTwoChecks) {
  constexpr int kSize = 300;  // 4.5 million block updates
  const FullMatrix full = full_matrix(kSize);
  BlockCholesky factor{full.pattern};
  ASSERT_TRUE(factor.factorise(full.diagonal, full.above));
  EXPECT_GT(factor.updates(), 4 * BlockCholesky::kUpdatesPerCheck);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(factor.factorise(full.diagonal, full.above, stop.get_token()));
  EXPECT_LE(factor.updates(), BlockCholesky::kUpdatesPerCheck + kSize * kSize / 2);  // and the longest row
  ASSERT_TRUE(factor.factorise(full.diagonal, full.above));
}

// The Schur complement of the last block columns, against the same from the inverse of the whole matrix.
TEST(BlockCholesky, LeavesTheLastColumns) {
  constexpr int kSize = 7, kLeft = 3;
  const FullMatrix full = full_matrix(kSize);
  BlockCholesky factor{full.pattern, kLeft};
  ASSERT_TRUE(factor.factorise(full.diagonal, full.above));
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(2 * kSize, 2 * kSize);
  for (int k = 0; k < 2 * kSize; ++k) {
    for (int i = k % 2; i < 2 * kSize; i += 2) whole(i, k) = i == k ? 4 : 1e-3;
  }
  const Eigen::MatrixXd inverse = whole.inverse();
  const Eigen::MatrixXd expected = inverse.bottomRightCorner(2 * kLeft, 2 * kLeft).inverse();
  for (int row = 0; row < kLeft; ++row) {
    for (int column = 0; column <= row; ++column) {
      const Block* block = factor.remaining(kSize - kLeft + row, kSize - kLeft + column);
      ASSERT_NE(block, nullptr);
      EXPECT_NEAR((*block)(0, 0), expected(2 * row, 2 * column), 1e-12);
      EXPECT_NEAR((*block)(1, 0), expected(2 * row + 1, 2 * column), 1e-12);
      EXPECT_NEAR((*block)(1, 1), expected(2 * row + 1, 2 * column + 1), 1e-12);
    }
  }
}

}  // namespace
}  // namespace selvage::lp::elimination
