// Tests of core/marker/validity.h: overlaps, spacing, protrusions and depths.
#include "core/marker/validity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"
#include "core/minkowski/cache.h"
#include "core/minkowski/nearest_edges.h"
#include "tests/core/marker/squares.h"
#include "tests/support/placed.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

marker::Validity checked(const Marker& marker) {
  SumCache sums;
  marker::Validity validity = check(marker, sums);
  EXPECT_EQ(validity.valid(), is_valid(marker));
  return validity;
}

// Runs the parts of a task in the opposite order, as threads might.
class Backwards final : public Executor {
 public:
  [[nodiscard]] std::size_t parallelism() const override { return 4; }
  void for_each(std::size_t count, const Part& part) const override {
    while (count > 0) part(--count);
  }
};

TEST(Validity, AllowsTouchingPieces) {
  EXPECT_TRUE(checked(squares({{0, 0}, {10, 0}, {10, 10}, {0, 90}})).valid());
}

TEST(Validity, ReportsOverlapsWithWitnessAndDepth) {
  const marker::Validity validity = checked(squares({{0, 0}, {50, 50}, {7, 2}}));
  ASSERT_EQ(validity.overlaps.size(), 1U);
  const marker::Overlap& overlap = validity.overlaps[0];
  EXPECT_EQ(overlap.first, PieceId{0});
  EXPECT_EQ(overlap.second, PieceId{2});
  EXPECT_NEAR(overlap.depth, 3, 1e-9);  // to the right, by the width of the overlap
  EXPECT_GT(overlap.witness_x, 7);
  EXPECT_LT(overlap.witness_x, 10);
  EXPECT_GT(overlap.witness_y, 2);
  EXPECT_LT(overlap.witness_y, 10);
  EXPECT_TRUE(validity.protrusions.empty());
}

TEST(Validity, CanBeCancelled) {
  SumCache sums;
  std::stop_source source;
  source.request_stop();
  const auto stopped = check(squares({{0, 0}, {7, 2}}), sums, source.get_token());
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::kStoppedEarly);
}

// Of 1,500 pieces at one position, 1,124,250 pairs overlap.
TEST(Validity, ListsOverlapsUpToALimit) {
  const Marker heap = squares(std::vector<Vec>(1'500, Vec{}));
  const marker::PlacedPieces pieces{heap};
  const auto listed = conflicts(pieces);
  ASSERT_EQ(listed.size(), 1'000'000U);
  EXPECT_TRUE(std::is_sorted(listed.begin(), listed.end()));
  EXPECT_EQ(std::adjacent_find(listed.begin(), listed.end()), listed.end());
  EXPECT_TRUE(listed == conflicts(pieces, Backwards{}));
  EXPECT_EQ(overlaps_unmeasured(heap).size(), listed.size());
  SumCache sums;
  EXPECT_EQ(check(heap, sums).overlaps.size(), 500'000U) << "measured";
}

TEST(Validity, NamesTheFirstFixedPiecesThatOverlap) {
  const Marker marker = squares({{0, 0}, {55, 0}, {5, 5}, {50, 0}, {9, 9}});
  const auto defect = defect_of_fixed(marker, {false, true, true, true, true});
  ASSERT_TRUE(defect);
  EXPECT_EQ(defect->field, "/pieces/3");
  EXPECT_FALSE(defect_of_fixed(marker, {true, true, false, false, false}));
}

TEST(Validity, FindsTheSameOverlapsUnmeasured) {
  const Marker marker = squares({{0, 0}, {5, 5}, {9, 9}, {60, 0}, {0, 1}});
  const auto measured = checked(marker).overlaps;
  const auto unmeasured = overlaps_unmeasured(marker);
  ASSERT_EQ(unmeasured.size(), measured.size());
  for (std::size_t k = 0; k < measured.size(); ++k) {
    EXPECT_EQ(unmeasured[k].first, measured[k].first);
    EXPECT_EQ(unmeasured[k].second, measured[k].second);
    EXPECT_EQ(unmeasured[k].witness_x, measured[k].witness_x);  // the pieces are boxes, so both witnesses are exact
    EXPECT_EQ(unmeasured[k].witness_y, measured[k].witness_y);
    EXPECT_EQ(unmeasured[k].depth, 0);
    EXPECT_GT(measured[k].depth, 0);
  }
}

TEST(Validity, DepthIsTheShortestSeparatingMove) {
  // The corner of a square lies inside a triangle with hypotenuse x + y = 20, at (7, 7): its depth is 6 / sqrt(2).
  Marker marker = squares({{0, 0}, {7, 7}});
  marker.shapes.push_back({.id = "triangle", .outline = kTriangle, .tilt_limit = {}});
  marker.pieces[0].shape.value = 1;
  const marker::Validity validity = checked(marker);
  ASSERT_EQ(validity.overlaps.size(), 1U);
  EXPECT_NEAR(validity.overlaps[0].depth, 6 / std::sqrt(2.0), 1e-9);
}

TEST(Validity, OverlapsAreSorted) {
  const marker::Validity validity = checked(squares({{0, 0}, {5, 5}, {9, 9}, {60, 0}, {0, 1}}));
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const marker::Overlap& o : validity.overlaps) pairs.emplace_back(o.first.value, o.second.value);
  EXPECT_EQ(pairs,
            (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 1}, {0, 2}, {0, 4}, {1, 2}, {1, 4}, {2, 4}}));
}

TEST(Validity, MeasuresPiecesOnTopOfEachOther) {
  const marker::Validity validity = checked(squares({{30, 30}, {30, 30}}));
  ASSERT_EQ(validity.overlaps.size(), 1U);
  EXPECT_NEAR(validity.overlaps[0].depth, 10, 1e-9);
}

TEST(Validity, AllowsPiecesAtExactlyTheSpacing) {
  Marker marker = squares({{0, 0}, {15, 0}});
  marker.spacing = 5;
  EXPECT_TRUE(checked(marker).valid());
  marker.spacing = 6;
  const marker::Validity validity = checked(marker);
  ASSERT_EQ(validity.overlaps.size(), 1U);
  EXPECT_NEAR(validity.overlaps[0].depth, 1, 1e-9);
  EXPECT_NEAR(validity.overlaps[0].witness_x, 12.5, 1e-9);  // midway between the two
  // Corner to corner, 3 and 4 apart along the axes.
  marker = squares({{0, 0}, {13, 14}});
  marker.spacing = 5;
  EXPECT_TRUE(checked(marker).valid());
  marker.pieces[1].at = {13, 13};
  EXPECT_FALSE(checked(marker).valid());
  EXPECT_NEAR(checked(marker).overlaps[0].depth, 5 - std::sqrt(18.0), 1e-9);
  // The pieces overlap: the depth is the move out of the overlap plus the spacing.
  marker.pieces[1].at = {8, 0};
  EXPECT_NEAR(checked(marker).overlaps[0].depth, 2 + 5, 1e-9);
}

TEST(Validity, SpacingDoesNotApplyToTheStripsEdges) {
  Marker marker = squares({{0, 0}});
  marker.spacing = 5;
  EXPECT_TRUE(checked(marker).valid());
}

TEST(Validity, MeasuresHowFarAPieceLeavesTheStrip) {
  const auto by = [](Vec at, std::optional<Coord> longest = {}) {
    Marker marker = squares({{40, 40}, at});
    marker.strip.longest = longest;
    const marker::Validity validity = checked(marker);
    EXPECT_TRUE(validity.overlaps.empty());
    if (validity.protrusions.empty()) return Coord{0};
    EXPECT_EQ(validity.protrusions.size(), 1U);
    EXPECT_EQ(validity.protrusions[0].piece, PieceId{1});
    return validity.protrusions[0].by;
  };
  EXPECT_EQ(by({0, 0}), 0);
  EXPECT_EQ(by({0, 90}), 0);
  EXPECT_EQ(by({0, 91}), 1);
  EXPECT_EQ(by({-3, 0}), 3);
  EXPECT_EQ(by({0, -4}), 4);
  EXPECT_EQ(by({-3, -4}), 4);  // the larger of the two protrusions
  EXPECT_EQ(by({1'000'000, 0}), 0);
  EXPECT_EQ(by({90, 0}, 100), 0);
  EXPECT_EQ(by({95, 0}, 100), 5);
}

// True when q overlaps p at r and at every position within a few units of r.
bool deep_inside(const Polygon& p, const Polygon& q, Vec r) {
  for (Coord x = -3; x <= 3; ++x) {
    for (Coord y = -3; y <= 3; ++y) {
      if (!overlap(placed(p), placed(q, r + Vec{x, y}))) return false;
    }
  }
  return true;
}

// No move shorter than the depth separates the two pieces, in any direction, and a move of that length does.
TEST(Validity, DepthIsExactlyTheMoveThatSeparates) {
  Random random{211};
  std::size_t pairs = 0;
  for (int trial = 0; trial < 200 / kSlowdown; ++trial) {
    const Polygon p = random_star(random, 12, 100'000);
    const Polygon q = random_star(random, 12, 100'000);
    const Vec r = random.point(-90'000, 90'000);
    if (!overlap(placed(p), placed(q, r))) continue;
    ++pairs;
    Marker marker = squares({{0, 0}, r});
    marker.shapes = {{.id = "p", .outline = p, .tilt_limit = {}}, {.id = "q", .outline = q, .tilt_limit = {}}};
    marker.pieces[1].shape.value = 1;
    SumCache sums;
    const marker::Validity validity = check(marker, sums);
    ASSERT_EQ(validity.overlaps.size(), 1U);
    const double depth = validity.overlaps[0].depth;
    for (int degrees = 0; degrees < 360; ++degrees) {
      const double angle = degrees * std::acos(-1.0) / 180;
      const double by = depth - 3;
      const Vec there = r + Vec{std::llround(by * std::cos(angle)), std::llround(by * std::sin(angle))};
      ASSERT_TRUE(overlap(placed(p), placed(q, there))) << text_of(p) << "; " << text_of(q) << " at " << text_of({r});
    }
    const minkowski::Obstacle obstacle =
        sums.obstacle(oriented_outline(marker, {0}, sums), oriented_outline(marker, {1}, sums));
    const minkowski::BoundaryPoint nearest = nearest_boundary_point(obstacle.sum(), obstacle.to_frame(r));
    ASSERT_NEAR(nearest.distance, depth, 1e-6);
    const Vec there = obstacle.from_frame({std::llround(nearest.at.x), std::llround(nearest.at.y)});
    ASSERT_FALSE(deep_inside(p, q, there)) << text_of(p) << "; " << text_of(q) << " at " << text_of({r});
  }
  EXPECT_GT(pairs, 50U / kSlowdown);
}

TEST(OrientedOutlines, AreThePiecesOutlines) {
  Marker marker = squares({{3, 4}});
  marker.shapes[0].outline = kTriangle;
  marker.shapes[0].may_flip = true;
  marker.shapes[0].tilt_limit = {5};
  SumCache sums;
  for (const double tilt : {0.0, 2.0}) {
    for (const double rotation : {0.0, 90.0, 180.0, 270.0}) {
      for (const bool flip : {false, true}) {
        marker.pieces[0].orientation = {flip, {rotation}, {tilt}};
        const outline::OrientedOutline piece = oriented_outline(marker, {0}, sums);
        EXPECT_EQ(moved(transformed(piece.outline->polygon, piece.symmetry), {3, 4}), placed_outline(marker, {0}));
      }
    }
  }
}

}  // namespace
}  // namespace selvage::test
