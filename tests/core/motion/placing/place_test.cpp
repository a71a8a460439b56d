#include "core/motion/placing/place.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "core/marker/clearance.h"
#include "core/marker/validity.h"
#include "core/minkowski/inner_fit.h"
#include "core/motion/placing/surroundings.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::placing {
namespace {

using test::Layout;

Marker with(Marker marker, std::uint32_t piece, Vec at) {
  marker.pieces[piece].at = at;
  return marker;
}
double distance(Vec a, Vec b) {
  return std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y));
}

std::optional<Place> placed(const Marker& marker, std::uint32_t piece, Vec wanted, bool may_grow = false) {
  SumCache sums;
  const scene::Scene scene{marker, sums};
  const auto found = place(scene, PieceId{piece}, wanted, {may_grow});
  if (found) {
    EXPECT_TRUE(is_valid(with(marker, piece, found->at)));
    EXPECT_DOUBLE_EQ(found->distance, distance(found->at, wanted));
    EXPECT_TRUE(found->grown || marker.strip.longest || length_of(with(marker, piece, found->at)) <= length_of(marker));
  }
  return found;
}

TEST(Place, KeepsAFreePosition) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 0}).put(square, {900, 0});
  EXPECT_EQ(placed(layout.marker(), 0, {800, 0})->at, (Vec{800, 0}));  // touching is free
  EXPECT_EQ(placed(layout.marker(), 0, {333, 777})->at, (Vec{333, 777}));
}

TEST(Surroundings, OfALargeGroupPollForAStop) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(10, 10));
  for (Coord k = 0; k < 100; ++k) layout.put(square, {10 * k, 0});
  Marker marker = layout.put(square, {5000, 500}).marker();
  for (std::size_t k = 0; k < 100; ++k) marker.pieces[k].group = "row";
  SumCache sums;
  const scene::Scene scene{marker, sums};
  const Body body{scene, PieceId{7}};
  EXPECT_EQ(body.members.size(), 100U);
  EXPECT_TRUE(body.holds(99));
  EXPECT_FALSE(body.holds(100));
  std::stop_source source;
  EXPECT_TRUE(Surroundings(scene, body, {{0, 0}, {0, 0}}, {}, source.get_token()).complete());
  source.request_stop();  // the group has no neighbour whose sum would notice
  EXPECT_FALSE(Surroundings(scene, body, {{0, 0}, {0, 0}}, {}, source.get_token()).complete());
}

TEST(Place, ComesBackIntoTheStrip) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 0}).put(square, {900, 0});
  EXPECT_EQ(placed(layout.marker(), 0, {-5000, -3})->at, (Vec{0, 0}));
  EXPECT_EQ(placed(layout.marker(), 0, {300, 4000})->at, (Vec{300, 900}));
  EXPECT_EQ(placed(layout.marker(), 0, {5000, 500})->at, (Vec{900, 500}));
}

TEST(Place, LeavesAnotherPieceByTheShortestWay) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 0}).put(square, {500, 500}).put(square, {900, 900});
  EXPECT_EQ(placed(layout.marker(), 0, {470, 520})->at, (Vec{400, 520}));
  EXPECT_EQ(placed(layout.marker(), 0, {520, 570})->at, (Vec{520, 600}));
}

TEST(Place, GoesWhereTwoBordersCross) {  // down into the notch between two squares, one unit too narrow to hold it
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  const auto wedge = layout.shape_of({{0, 0}, {50, 100}, {-50, 100}});  // stands on its tip
  layout.put(square, {400, 0}).put(square, {560, 0}).put(wedge, {900, 500});
  EXPECT_EQ(placed(layout.marker(), 2, {530, 30})->at, (Vec{530, 40}));
}

TEST(Place, FindsAHoleThatFitsExactly) {  // one position, and a slot of no width that leads to another
  Layout layout{300};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {100, 100});
  for (const Coord x : {0, 100, 200}) layout.put(square, {x, 0}).put(square, {x, 200});
  layout.put(square, {200, 100});
  EXPECT_EQ(placed(layout.marker(), 0, {20, 90})->at, (Vec{20, 100}));
  layout.put(square, {0, 100});
  EXPECT_EQ(placed(layout.marker(), 0, {130, 90})->at, (Vec{100, 100}));
}

TEST(Place, FindsNothingWhenCancelled) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 0}).put(square, {500, 500});
  const Marker marker = layout.marker();
  SumCache sums;
  std::stop_source source;
  source.request_stop();
  const auto stopped = repair_and_place(marker, PieceId{1}, {50, 50}, {}, {sums, source.get_token()});
  ASSERT_TRUE(stopped);
  EXPECT_FALSE(stopped->place);
  EXPECT_EQ(stopped->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(stopped->marker, marker);
  EXPECT_EQ(sums.counts().entries, 0U);
}

TEST(Place, KeepsTheSpacingRoundCorners) {
  Layout layout{100'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(square, {50'000, 50'000}).put(square, {80'000, 0}).spaced(5'000);
  const auto found = placed(layout.marker(), 1, {62'000, 62'000});
  ASSERT_TRUE(found);
  EXPECT_NEAR(distance(found->at, {60'000, 60'000}), 5'000, 3);
  EXPECT_NEAR(static_cast<double>(found->at.x), static_cast<double>(found->at.y), 3);
}

TEST(Place, UsesTheAllowanceAndTurnsAboutTheFootOfANotch) {
  Layout layout{100'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  const auto notched =
      layout.shape_of({{0, 0}, {60'000, 0}, {60'000, 20'000}, {20'000, 20'000}, {20'000, 60'000}, {0, 60'000}});
  layout.put(notched, {0, 0}).put(square, {80'000, 80'000}).overlapping(500);
  EXPECT_EQ(placed(layout.marker(), 1, {15'000, 40'000})->at, (Vec{19'500, 40'000}));
  const auto found = placed(layout.marker(), 1, {19'000, 19'000});
  ASSERT_TRUE(found);
  EXPECT_NEAR(distance(found->at, {20'000, 20'000}), 500, 3);
  EXPECT_NEAR(static_cast<double>(found->at.x), static_cast<double>(found->at.y), 3);
}

TEST(Place, GoesAlongTheStripsEdgeToABorderThatTheAllowanceMoved) {
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  const auto slope = layout.shape_of({{0, 0}, {20'000, 0}, {20'000, 771'000}, {0, 37'300}});
  layout.put(slope, {0, 0}).put(square, {60'000, 80'000}).overlapping(500);
  const Vec wanted{-3'000, 380'000};
  const auto found = placed(layout.marker(), 1, wanted);
  ASSERT_TRUE(found);
  EXPECT_LE(found->at.x, 1);
  EXPECT_FALSE(is_valid(with(layout.marker(), 1, found->at - Vec{0, 80})));  // two units from the slope
}

TEST(Place, ReportsWhenThereIsNoRoom) {
  Layout layout{100};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 0}).put(square, {100, 0}).put(square, {50, 0});  // the third lies on the others
  EXPECT_FALSE(placed(layout.marker(), 2, {40, 10}));
  const auto grown = placed(layout.marker(), 2, {40, 10}, true);
  ASSERT_TRUE(grown);
  EXPECT_TRUE(grown->grown);
  EXPECT_EQ(grown->at, (Vec{200, 0}));
  Marker on_cloth = layout.marker();
  on_cloth.strip.longest = 250;
  EXPECT_FALSE(placed(on_cloth, 2, {40, 10}, true));
  on_cloth.strip.longest = 300;
  EXPECT_EQ(placed(on_cloth, 2, {40, 10})->at, (Vec{200, 0}));
}

TEST(Place, KeepsLocksGroupsBuffersAndMargins) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {300, 300}).put(square, {600, 300}).put(square, {900, 850}).put(square, {700, 300});
  Marker marker = layout.marker();
  marker.pieces[0].locked = Locks{false, true, false};
  EXPECT_EQ(placed(marker, 0, {520, 700})->at, (Vec{500, 300}));  // only along its free axis
  marker.pieces[0].locked = true;
  EXPECT_EQ(placed(marker, 0, {520, 700})->at, (Vec{300, 300}));
  marker.pieces[0].locked = false;
  marker.pieces[0].buffer = 10;
  EXPECT_EQ(placed(marker, 0, {520, 320})->at, (Vec{490, 320}));
  marker.strip.margin = 5;
  EXPECT_EQ(placed(marker, 0, {-100, 320})->at, (Vec{5, 320}));
  marker.pieces[1].group = marker.pieces[3].group = "pair";
  SumCache sums;
  const auto answer = repair_and_place(marker, PieceId{1}, {120, 330}, {}, {sums});  // the pair is 200 long
  ASSERT_TRUE(answer && answer->place);
  EXPECT_TRUE(is_valid(answer->marker));
  EXPECT_EQ(answer->place->at, (Vec{90, 330}));  // the other comes to the buffered piece
  EXPECT_EQ(answer->marker.pieces[3].at, (Vec{190, 330}));
}

TEST(Place, RepairsOnlyTheOtherPieces) {
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  layout.put(square, {0, 0}).put(square, {99'990, 50'000}).put(square, {50'000, 20'000});
  SumCache sums;
  const auto answer = repair_and_place(layout.marker(), PieceId{2}, {50'000, 20'000}, {}, {sums});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->repair.pairs, 1U);
  ASSERT_TRUE(answer->place);
  EXPECT_TRUE(marker::is_valid(answer->marker));
  EXPECT_EQ(answer->marker.pieces[2].at, answer->place->at);
}

// The nearest free position among those of a grid and the piece's own.  The result of place() must not be farther away.
double nearest_by_trying(const Marker& marker, std::uint32_t piece, Vec wanted, Coord step) {
  const Polygon own =
      oriented(marker.shapes[marker.pieces[piece].shape.value].outline, marker.pieces[piece].orientation);
  const Box fit = minkowski::inner_fit(box_of(own), marker.strip.room(length_of(marker)));
  const marker::PlacedPieces pieces{marker};
  const auto free = [&](Vec at) {
    geometry::PlacedPolygon moved = pieces[piece];
    moved.at = at;
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
      if (k == piece) continue;
      if (marker::collide(moved, pieces[k], pieces.spacing({piece, k}))) return false;
    }
    return true;
  };
  double best = std::numeric_limits<double>::infinity();
  for (Coord x = fit.low.x; x <= fit.high.x; x += step) {
    for (Coord y = fit.low.y; y <= fit.high.y; y += step) {
      const double away = distance({x, y}, wanted);
      if (away < best && free({x, y})) best = away;
    }
  }
  return best;
}

// Some pieces, closer together than in loose_marker, and a piece to place among them.
struct Drop {
  Marker marker;
  std::uint32_t piece{};
  Vec wanted;
};
Drop random_drop() {
  Drop drop{test::loose_marker(*rc::gen::arbitrary<std::uint32_t>(), 4, 3, 1000), 0, {}};
  for (Piece& piece : drop.marker.pieces) {  // closer together: spiky pieces are about 3/4 of their boxes
    piece.at = {1000 + (piece.at.x - 1000) * 17 / 20, 1000 + (piece.at.y - 1000) / 10 * 9};
  }
  drop.marker.spacing = *rc::gen::element<Coord>(0, 0, 0, 40);
  drop.marker.overlap = *rc::gen::element<Coord>(0, 0, 30, 150);
  drop.piece = *rc::gen::inRange<std::uint32_t>(0, 12);
  drop.wanted = {*rc::gen::inRange<Coord>(-500, length_of(drop.marker) + 500),
                 *rc::gen::inRange<Coord>(-500, drop.marker.strip.width + 500)};
  Marker others = drop.marker;
  others.pieces.erase(others.pieces.begin() + drop.piece);
  RC_PRE(is_valid(others));
  return drop;
}

RC_GTEST_PROP(PlaceLaws, FindsTheNearestFreePosition, ()) {
  const Drop drop = random_drop();
  const auto found = placed(drop.marker, drop.piece, drop.wanted);
  const double by_trying = nearest_by_trying(drop.marker, drop.piece, drop.wanted, 97);
  if (std::isfinite(by_trying)) {
    RC_ASSERT(found.has_value());
    RC_ASSERT(found->distance <= by_trying + 4);
  }
}

RC_GTEST_PROP(PlaceLaws, NoSmallStepLeadsCloser, ()) {
  const Drop drop = random_drop();
  const auto found = placed(drop.marker, drop.piece, drop.wanted);
  if (!found || found->distance <= 8) return;
  for (const double step : {12.0, 60.0}) {
    for (int k = 0; k < 48; ++k) {
      const double angle = 2 * std::numbers::pi * k / 48;
      const Vec at = found->at + Vec{std::llround(step * std::cos(angle)), std::llround(step * std::sin(angle))};
      const Marker moved = with(drop.marker, drop.piece, at);
      if (distance(at, drop.wanted) > found->distance - 4 || length_of(moved) > length_of(drop.marker)) continue;
      RC_ASSERT(!is_valid(moved));
    }
  }
}

RC_GTEST_PROP(PlaceLaws, PlacingAgainChangesNothing, ()) {
  const Drop drop = random_drop();
  const auto found = placed(drop.marker, drop.piece, drop.wanted);
  if (!found) return;
  const auto again = placed(with(drop.marker, drop.piece, found->at), drop.piece, found->at);
  RC_ASSERT(again->at == found->at);
  RC_ASSERT(again->distance == 0);
}

}  // namespace
}  // namespace selvage::motion::placing
