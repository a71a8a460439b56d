// Tests the judge of the soak test against CGAL, and on markers with one known fault each.
#include "tests/judge/judge.h"

#include <gtest/gtest.h>

#include "tests/judge/exact_pairs.h"
#include "tests/laws/random_marker.h"
#include "tests/support/exact.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

// On small lattices, polygons touch in every possible way.
TEST(Judge, AgreesWithCgalOnPairs) {
  Random random{201};
  int overlapping = 0;
  const int trials = 3000 / kSlowdown;
  for (int trial = 0; trial < trials; ++trial) {
    const Coord extent = random.chance(70) ? random.between(4, 16) : random.between(1000, kLatticeLimit / 4);
    const Polygon p = random_polygon(random, extent);
    const Polygon q =
        random.chance(5) ? p : moved(random_polygon(random, extent), random.point(-extent / 2, extent / 2));
    const bool expected = interiors_meet(p, q);
    ASSERT_EQ(interiors_share(p, q), expected) << text_of(p) << " and " << text_of(q);
    ASSERT_EQ(interiors_share(q, p), expected) << text_of(p) << " and " << text_of(q);
    overlapping += expected ? 1 : 0;
  }
  EXPECT_GT(overlapping, trials / 4);
  EXPECT_LT(overlapping, trials);
}

TEST(Judge, AgreesWithCgalOnDistances) {
  Random random{202};
  int nearer = 0;
  const int trials = 1000 / kSlowdown;
  for (int trial = 0; trial < trials; ++trial) {
    const Coord extent = random.chance(70) ? random.between(4, 16) : random.between(1000, kLatticeLimit / 8);
    const Polygon p = random_polygon(random, extent);
    const Polygon q = moved(random_polygon(random, extent), random.point(-2 * extent, 2 * extent));
    const Coord distance = random.between(1, extent);
    const bool expected = interiors_meet(p, q) || compare_distance(p, q, distance) < 0;
    ASSERT_EQ(nearer_than(p, q, distance), expected) << text_of(p) << " and " << text_of(q) << ", " << distance;
    nearer += expected ? 1 : 0;
  }
  EXPECT_GT(nearer, trials / 4);
  EXPECT_LT(nearer, trials);
}

TEST(Judge, DetectsContainedAndIdenticalPolygons) {
  const Polygon large{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const Polygon small{{2, 2}, {4, 2}, {4, 4}, {2, 4}};
  EXPECT_TRUE(interiors_share(large, small));
  EXPECT_TRUE(interiors_share(small, large));
  EXPECT_TRUE(interiors_share(large, large));
  EXPECT_FALSE(interiors_share(large, moved(large, {10, 3})));
}

TEST(Judge, DetectsPolygonsThatTouchThemselves) {
  EXPECT_FALSE(touches_itself({{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_TRUE(touches_itself({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}));
  EXPECT_TRUE(touches_itself({{0, 0}, {4, 4}, {4, 0}, {0, 4}}));
}

TEST(ExactPairs, AreSeparatedByTheShortestTranslation) {
  const Polygon square{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  const Polygon aside{{92, 40}, {192, 40}, {192, 140}, {92, 140}};
  EXPECT_TRUE(separable_within(square, aside, 8));
  EXPECT_FALSE(separable_within(square, aside, 7));
  // A block pushed by (8, 6) into the notch of an L.
  const Polygon notched{{0, 0}, {300, 0}, {300, 100}, {100, 100}, {100, 300}, {0, 300}};
  const Polygon block{{92, 94}, {192, 94}, {192, 194}, {92, 194}};
  EXPECT_TRUE(separable_within(notched, block, 10));
  EXPECT_FALSE(separable_within(notched, block, 9));
}

// Two squares of side 100, 10 apart and 5 from the edges of a strip 120 wide that ends at 300.
Marker two_squares() {
  Marker marker;
  marker.strip = {120, 300, 5};
  Shape square;
  square.outline = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  square.tilt_limit = Angle::of_degrees(2);
  marker.shapes.push_back(square);
  marker.pieces.push_back({.id = "a", .shape = {}, .orientation = {}, .at = {5, 5}});
  marker.pieces.push_back({.id = "b", .shape = {}, .orientation = {}, .at = {115, 5}});
  return marker;
}

TEST(Judge, DescribesFaults) {
  Judge judge;
  const Marker good = two_squares();
  EXPECT_EQ(judge.fault_of(good), "");
  EXPECT_EQ(judge.length_of(good), 215);
  Marker bad = good;
  bad.pieces[1].at.x = 104;
  EXPECT_EQ(judge.fault_of(bad), "piece a overlaps piece b");
  bad = good;
  bad.spacing = 10;
  EXPECT_EQ(judge.fault_of(bad), "");
  bad.pieces[1].buffer = 6;
  bad.pieces[0].buffer = 5;
  EXPECT_EQ(judge.fault_of(bad), "piece a is too close to piece b");
  bad = good;
  bad.overlap = 5;
  bad.pieces[1].at.x = 100;
  EXPECT_EQ(judge.fault_of(bad), "");
  bad.pieces[1].at.x = 99;
  EXPECT_EQ(judge.fault_of(bad), "piece a overlaps piece b");
  bad.pieces[0].overlap = 6;  // the smaller allowance of the two counts
  EXPECT_EQ(judge.fault_of(bad), "piece a overlaps piece b");
  bad.pieces[1].overlap = 6;
  EXPECT_EQ(judge.fault_of(bad), "");
  bad.spacing = 1;
  EXPECT_EQ(judge.fault_of(bad), "piece a overlaps piece b");
  for (const Vec by : {Vec{-1, 0}, Vec{0, -1}, Vec{0, 11}}) {
    bad = good;
    bad.pieces[0].at = bad.pieces[0].at + by;
    EXPECT_EQ(judge.fault_of(bad), "piece a leaves the strip");
  }
  bad = good;
  bad.pieces[1].at.x = 196;
  EXPECT_EQ(judge.fault_of(bad), "piece b leaves the strip");
}

TEST(Judge, DescribesBrokenRules) {
  Judge judge;
  Marker marker = two_squares();
  marker.shade = 210;
  for (Piece& piece : marker.pieces) piece.rules.shade = "A";
  const auto with = [&](marker::Rules rules) {
    marker.pieces[0].rules = rules;
    return judge.fault_of(marker);
  };
  EXPECT_EQ(with({.below = 5, .above = 15, .from = 5, .to = 105, .shade = "A"}), "");
  EXPECT_EQ(with({.below = 6}), "piece a is too near the lower edge");
  EXPECT_EQ(with({.above = 16}), "piece a is too near the upper edge");
  EXPECT_EQ(with({.from = 6}), "piece a lies before its band");
  EXPECT_EQ(with({.to = 104}), "piece a lies behind its band");
  EXPECT_EQ(with({.on_fold = true}), "piece a is not on the fold");
  marker.strip.repeat = {.along = 7, .across = 3, .phase = {1, 1}};
  EXPECT_EQ(with({.match = Vec{10, 8}, .shade = "A"}), "");
  EXPECT_EQ(with({.match = Vec{11, 8}, .shade = "A"}), "piece a is not matched along x");
  EXPECT_EQ(with({.zone = true}), "");
  {
    Marker covered = marker;
    covered.strip.repeat = {};
    covered.shade.reset();
    covered.pieces[1].at = covered.pieces[0].at;
    covered.pieces[1].rules = {.quality = 2};
    const auto zone_of = [&](std::optional<marker::Quality> quality) {
      covered.pieces[0].rules = {.zone = true, .quality = quality};
      return judge.fault_of(covered);
    };
    EXPECT_EQ(zone_of(2), "");
    EXPECT_EQ(zone_of(3), "piece a overlaps piece b");
    EXPECT_EQ(zone_of(std::nullopt), "piece a overlaps piece b");
    Marker tube = two_squares();
    tube.pieces[0].rules.on_fold = true;
    tube.pieces[0].at.y += tube.strip.width - box_of(placed_outline(tube, PieceId{0})).high.y;
    EXPECT_EQ(judge.fault_of(tube), "piece a leaves the strip");
    tube.strip.tube = true;
    EXPECT_EQ(judge.fault_of(tube), "");
    tube.pieces[0].at.y -= 1;
    EXPECT_EQ(judge.fault_of(tube), "piece a leaves the strip");
  }
  EXPECT_EQ(with({.shade = "A", .nap = marker::Nap::kUp}), "");
  EXPECT_EQ(with({.shade = "A", .nap = marker::Nap::kDown}), "piece a lies against its nap");
  EXPECT_EQ(with({.match = Vec{10, 9}, .shade = "A"}), "piece a is not matched along y");
  // A set of two: from one match point to the other there are whole repeats.
  const Vec b = marker.pieces[1].at;
  marker.pieces[1].rules = {.match = Vec{0, 0}, .match_set = "S"};
  const Vec same = b - marker.pieces[0].at;
  EXPECT_EQ(with({.match = same + Vec{14, -6}, .match_set = "S"}), "");
  EXPECT_EQ(with({.match = same + Vec{13, 0}, .match_set = "S"}),
            "piece b is out of phase with piece a of its match set");
  EXPECT_EQ(with({.match = same + Vec{0, 1}, .match_set = "S"}),
            "piece b is out of phase with piece a of its match set");
  EXPECT_EQ(with({.match = same + Vec{0, 1}, .match_set = "T"}), "");
  marker.pieces[1].rules = {.shade = "A"};
  marker.shade = 209;
  EXPECT_EQ(with({.shade = "B"}), "");
  EXPECT_EQ(with({.shade = "A"}), "piece a is too far from piece b of its shade");
  marker.strip.below = 6;
  EXPECT_EQ(with({}), "piece a leaves the strip");
}

TEST(Judge, DescribesForbiddenChanges) {
  Judge judge;
  Marker before = two_squares();
  const Leave none{.longest = 215};
  Marker after = before;
  EXPECT_EQ(judge.broken_promise(before, after, none), "");
  after.pieces[1].at.x += 1;
  EXPECT_EQ(judge.broken_promise(before, after, none), "the marker is 1 units too long");
  after.pieces[1].at.x -= 2;
  EXPECT_EQ(judge.broken_promise(before, after, none), "");
  before.pieces[1].locked = {true, false, false};
  after.pieces[1].locked = before.pieces[1].locked;
  EXPECT_EQ(judge.broken_promise(before, after, none), "piece b moved along a locked x");
  before.pieces[1].locked = after.pieces[1].locked = false;
  for (Marker* marker : {&before, &after}) marker->pieces[0].group = marker->pieces[1].group = "g";
  EXPECT_EQ(judge.broken_promise(before, after, none), "piece a moved away from its group");

  before = after = two_squares();
  after.pieces[0].orientation.tilt = Angle::of_degrees(1);
  EXPECT_EQ(judge.broken_promise(before, after, none), "piece a was tilted");
  const Leave tilts{.longest = 300, .tilts = true};
  EXPECT_EQ(judge.broken_promise(before, after, tilts), "");
  after.pieces[0].orientation.tilt = Angle::of_degrees(-2.5);
  EXPECT_EQ(judge.broken_promise(before, after, tilts), "piece a was tilted too far");
  after.pieces[0].orientation = {false, Angle::of_degrees(90), {}};
  EXPECT_EQ(judge.broken_promise(before, after, tilts), "piece a has a rotation that is not allowed");
  after = before;
  after.pieces[0].buffer = 1;
  EXPECT_EQ(judge.broken_promise(before, after, none), "the marker is a different one");
}

}  // namespace
}  // namespace selvage::test
