#include "core/matching/alignment.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/support/exact.h"
#include "tests/support/polygons.h"

namespace selvage::matching {
namespace {

const Polygon kSquare{{0, 0}, {100, 0}, {100, 100}, {0, 100}};

TEST(SymmetricDifference, OfShiftedSquares) {
  EXPECT_EQ(symmetric_difference(kSquare, kSquare, {}), 0);
  EXPECT_EQ(symmetric_difference(kSquare, kSquare, {30, 0}), 6000);
  EXPECT_EQ(symmetric_difference(kSquare, kSquare, {100, 0}), 20'000);
  EXPECT_EQ(shared_area(kSquare, kSquare, {50, 50}), 2500);
  EXPECT_EQ(shared_area(kSquare, kSquare, {500, 0}), 0);
}

TEST(SymmetricDifference, AgreesWithCgal) {
  test::Random random{6};
  for (int trial = 0; trial < 60 / test::kSlowdown + 1; ++trial) {
    const Polygon first = test::random_polygon(random, 100'000);
    const Polygon second = test::random_polygon(random, 100'000);
    const Vec by = random.point(-30'000, 30'000);
    const Polygon moved = geometry::moved(second, by);
    const Box box = united(box_of(first), box_of(moved));
    double covered = static_cast<double>(box.width()) * static_cast<double>(box.height());
    for (const double area : test::areas_left_over(box, std::array{first, moved})) covered -= area;
    const auto area_of = [](const Polygon& p) { return geometry::area_of(p); };
    const double exact = 2 * covered - area_of(first) - area_of(second);
    // Every crossing may be a unit off on an outline of at most some hundred thousand units.
    EXPECT_NEAR(symmetric_difference(first, second, by), exact, 4e6);
    EXPECT_NEAR(symmetric_difference(second, first, -by), exact, 4e6);
  }
}

TEST(BestAlignment, UndoesATranslation) {
  test::Random random{7};
  for (int trial = 0; trial < 50; ++trial) {
    const Polygon outline = test::random_polygon(random, 50'000);
    const Vec by = random.point(-100'000, 100'000);
    const Alignment alignment = best_alignment(outline, geometry::moved(outline, -by));
    EXPECT_EQ(alignment.by, by);
    EXPECT_EQ(alignment.difference, 0);
  }
}

TEST(BestAlignment, IsNotWorseThanAligningTheMiddlesOfTheBoxes) {
  test::Random random{8};
  for (int trial = 0; trial < 30; ++trial) {
    const Polygon first = test::random_star(random, 12, 10'000);
    const Polygon second = test::random_star(random, 12, 10'000);
    const Alignment best = best_alignment(first, second);
    EXPECT_NEAR(best.difference, symmetric_difference(first, second, best.by), 1e-6);
    const Box a = box_of(first);
    const Box b = box_of(second);
    const Vec middles{(a.low.x + a.high.x) / 2 - (b.low.x + b.high.x) / 2,
                      (a.low.y + a.high.y) / 2 - (b.low.y + b.high.y) / 2};
    EXPECT_LE(best.difference, symmetric_difference(first, second, middles) + 1e5);
  }
}

}  // namespace
}  // namespace selvage::matching
