#include "core/model/snap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace selvage::model {
namespace {

TEST(Snap, KeepsWholeDifferencesInSpiteOfSolverNoise) {
  std::mt19937 random{1};
  std::uniform_real_distribution<double> anywhere{-1e6, 1e6};
  std::uniform_real_distribution<double> noise{-1e-7, 1e-7};
  for (int trial = 0; trial < 2'000; ++trial) {
    // Chains of pieces that touch: differences are whole numbers up to noise.
    std::vector<RealVec> moves;
    for (int chain = 0; chain < 10; ++chain) {
      double x = anywhere(random);
      double y = anywhere(random);
      for (int k = 0; k < 5; ++k) {
        moves.push_back({x + noise(random), y + noise(random)});
        x += static_cast<double>(random() % 100);
        y -= static_cast<double>(random() % 100);
      }
    }
    const auto whole = snapped(moves);
    for (std::size_t k = 0; k + 1 < moves.size(); ++k) {
      if (k % 5 == 4) continue;
      EXPECT_EQ(whole[k + 1].x - whole[k].x, std::llround(moves[k + 1].x - moves[k].x));
      EXPECT_EQ(whole[k + 1].y - whole[k].y, std::llround(moves[k + 1].y - moves[k].y));
    }
  }
}

TEST(Snap, KeepsFixedPiecesAndRoundsOthersByLessThanAUnit) {
  std::mt19937 random{2};
  std::uniform_real_distribution<double> anywhere{-1e3, 1e3};
  std::vector<RealVec> moves{{0, 0}};
  for (int k = 0; k < 100; ++k) moves.push_back({anywhere(random), anywhere(random)});
  const auto whole = snapped(moves);
  EXPECT_EQ(whole[0], (Vec{0, 0}));
  for (std::size_t k = 0; k < moves.size(); ++k) {
    EXPECT_LT(std::abs(static_cast<double>(whole[k].x) - moves[k].x), 1);
    EXPECT_LT(std::abs(static_cast<double>(whole[k].y) - moves[k].y), 1);
  }
}

}  // namespace
}  // namespace selvage::model
