#include "core/model/contacts/contact.h"

#include <gtest/gtest.h>

#include "tests/core/motion/markers.h"

namespace selvage::model::contacts {
namespace {

constexpr double kTolerance = 4;

// Two squares of 100 units: their sum is the square from (-100, -100) to (100, 100).
class SquareBySquare : public ::testing::Test {
 protected:
  [[nodiscard]] Backing backing(double nx, double ny, Vec r, Coord spacing = 0) const {
    return backing_of({{0, 1}, nx, ny, 0}, {obstacle_, r, r, spacing}, kTolerance);
  }

 private:
  SumCache sums_;
  std::shared_ptr<const outline::Outline> square_ = sums_.outline(test::rectangle(100, 100));
  minkowski::Obstacle obstacle_ = sums_.obstacle({square_, {}}, {square_, {}});
};

TEST_F(SquareBySquare, EdgesBackTheirRows) {
  EXPECT_EQ(backing(1, 0, {100, 30}), Backing::kEdge);
  EXPECT_EQ(backing(1, 0, {103, -60}), Backing::kEdge);
  EXPECT_EQ(backing(0, -1, {10, -100}), Backing::kEdge);
}

TEST_F(SquareBySquare, NothingBacksARowBeyondItsEdge) {
  EXPECT_EQ(backing(1, 0, {100, 150}), Backing::kNone);  // on the edge's line, above it
  EXPECT_EQ(backing(1, 0, {130, 30}), Backing::kNone);   // far from it
  EXPECT_EQ(backing(0, 1, {100, 30}), Backing::kNone);   // not along this row
}

TEST_F(SquareBySquare, ACornerIsNotAFirmContact) {
  EXPECT_EQ(backing(1, 0, {100, 100}), Backing::kCorner);
  EXPECT_EQ(backing(0, 1, {100, 100}), Backing::kCorner);
  EXPECT_EQ(backing(1, 0, {100, -98}), Backing::kCorner);
}

TEST_F(SquareBySquare, ASpacingRoundsTheCorner) {
  EXPECT_EQ(backing(1, 0, {150, 30}, 50), Backing::kEdge);
  EXPECT_EQ(backing(0.6, 0.8, {130, 140}, 50), Backing::kEdge);  // 50 from the corner
  EXPECT_EQ(backing(1, 0, {150, 120}, 50), Backing::kNone);      // farther than that
}

TEST_F(SquareBySquare, WithAnAllowanceAContactIsAsDeepAsAllowed) {
  EXPECT_EQ(backing(1, 0, {80, 30}, -20), Backing::kEdge);
  EXPECT_EQ(backing(1, 0, {90, 30}, -20), Backing::kNone);    // not as deep as it may be
  EXPECT_EQ(backing(0, 1, {80, 30}, -20), Backing::kNone);    // not along this row
  EXPECT_EQ(backing(1, 0, {80, 80}, -20), Backing::kCorner);  // either way out is as short
  EXPECT_EQ(backing(1, 0, {80, 90}, -20), Backing::kNone);    // the other way out is shorter
}

TEST(Backing, WithAnAllowanceANotchIsAnArc) {
  SumCache sums;
  const auto notched = sums.outline({{0, 0}, {300, 0}, {300, 100}, {100, 100}, {100, 300}, {0, 300}});
  const auto square = sums.outline(test::rectangle(50, 50));
  const minkowski::Obstacle obstacle = sums.obstacle({notched, {}}, {square, {}});
  const Vec r{84, 88};  // 20 from the foot of the notch
  EXPECT_EQ(backing_of({{0, 1}, 0.8, 0.6, 0}, {obstacle, r, r, -20}, kTolerance), Backing::kEdge);
  EXPECT_EQ(backing_of({{0, 1}, 1, 0, 0}, {obstacle, r, r, -20}, kTolerance), Backing::kNone);
}

TEST(Backing, TheFootOfANotchIsFirm) {
  // A square in the notch of an L: it touches both sides.
  SumCache sums;
  const auto notched = sums.outline({{0, 0}, {300, 0}, {300, 100}, {100, 100}, {100, 300}, {0, 300}});
  const auto square = sums.outline(test::rectangle(50, 50));
  const minkowski::Obstacle obstacle = sums.obstacle({notched, {}}, {square, {}});
  const Vec r{100, 100};
  for (const auto& [nx, ny] : {std::pair{1.0, 0.0}, {0.0, 1.0}}) {
    EXPECT_EQ(backing_of({{0, 1}, nx, ny, 0}, {obstacle, r, r, 0}, kTolerance), Backing::kEdge);
  }
}

}  // namespace
}  // namespace selvage::model::contacts
