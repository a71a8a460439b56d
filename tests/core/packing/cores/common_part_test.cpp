#include "core/packing/cores/common_part.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/motion/markers.h"

namespace selvage::packing::cores {
namespace {

const Polygon kL{{0, 0}, {100, 0}, {100, 40}, {40, 40}, {40, 100}, {0, 100}};

TEST(LiesWithin, MayTouchTheBorder) {
  EXPECT_TRUE(lies_within(test::rectangle(40, 100), kL));
  EXPECT_TRUE(lies_within(kL, kL));
}

TEST(LiesWithin, IsExactAtANotch) {
  EXPECT_FALSE(lies_within(test::rectangle(41, 100), kL));
  EXPECT_FALSE(lies_within(moved(test::rectangle(10, 10), {50, 50}), kL));
  EXPECT_FALSE(lies_within(moved(test::rectangle(10, 10), {95, 0}), kL));
}

TEST(BestFit, PutsAPolygonOnItsCopy) {
  const Polygon trapezoid{{0, 0}, {10'000, 0}, {8'000, 3'000}, {2'000, 3'000}};
  const Fit fit = best_fit(moved(trapezoid, {500, -700}), trapezoid);
  EXPECT_EQ(fit.by, (Vec{500, -700}));
  EXPECT_NEAR(fit.area, 24e6, 1e5);
}

// A core that is as wide and as high as it can be blocks more than one of more area.
TEST(BestFit, KeepsTheWidthAndTheHeight) {
  const Polygon trapezoid{{0, 0}, {10'000, 0}, {5'000, 3'000}, {4'000, 3'000}};
  const Polygon turned{{6'000, 0}, {5'000, 0}, {0, 3'000}, {10'000, 3'000}};
  const Fit fit = best_fit(trapezoid, Polygon{turned[1], turned[0], turned[3], turned[2]});
  EXPECT_EQ(fit.by, (Vec{0, 0}));
}

TEST(CommonPart, IsSmallerByAFewUnits) {
  const Polygon part = common_part(test::rectangle(1'000, 400), moved(test::rectangle(1'000, 400), {300, 100}));
  const Box box = box_of(part);
  EXPECT_EQ(box, (Box{{304, 104}, {996, 396}}));
}

TEST(CommonPart, IsEmptyWhereThereIsNone) {
  EXPECT_TRUE(common_part(test::rectangle(100, 100), moved(test::rectangle(100, 100), {100, 0})).empty());
  EXPECT_TRUE(common_part(test::rectangle(100, 100), moved(test::rectangle(100, 100), {98, 0})).empty());
}

TEST(CommonPart, LiesWithinBoth) {
  std::mt19937 random{5};
  int found = 0;
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    const Polygon p = test::spiky(random, 12, 20'000);
    const Polygon q = moved(test::spiky(random, 9, 20'000), {static_cast<Coord>(random() % 8'000), 0});
    const Polygon part = common_part(p, q);
    if (part.empty()) continue;
    ++found;
    EXPECT_GT(doubled_area(part), 0);
    for (const Vec corner : part) {
      EXPECT_NE(geometry::locate(corner, p), geometry::Location::kOutside);
      EXPECT_NE(geometry::locate(corner, q), geometry::Location::kOutside);
    }
  }
  EXPECT_GT(found, 150);
}

}  // namespace
}  // namespace selvage::packing::cores
