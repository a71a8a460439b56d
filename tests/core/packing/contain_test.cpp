#include "core/packing/contain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/marker/validity.h"
#include "core/packing/bodies/on_cloth.h"
#include "core/packing/roomiest.h"
#include "tests/core/motion/markers.h"
#include "tests/core/packing/polyominoes.h"

namespace selvage::packing {
namespace {

std::vector<PieceId> all_of(const Marker& marker) {
  std::vector<PieceId> pieces;
  for (std::uint32_t k = 0; k < marker.pieces.size(); ++k) pieces.push_back({k});
  return pieces;
}

Containment contained(const Marker& marker, const std::vector<PieceId>& pieces, const Container& room,
                      const ContainSettings& settings = {}) {
  SumCache sums;
  Containment result = contain(marker, pieces, room, settings, {sums});
  if (result.verdict != Verdict::kFound) {
    EXPECT_EQ(result.marker, marker);
  }
  return result;
}

// A locked U that opens to the right; its slot is 10 mm wide and 20 mm deep.
test::Layout with_slot() {
  test::Layout layout{30'000};
  const auto u = layout.shape_of({{0, 0},
                                  {30'000, 0},
                                  {30'000, 10'000},
                                  {10'000, 10'000},
                                  {10'000, 20'000},
                                  {30'000, 20'000},
                                  {30'000, 30'000},
                                  {0, 30'000}});
  layout.put(u, {0, 0}, 0, true);
  return layout;
}

TEST(Contain, FillsAGapWithoutSlack) {
  test::Layout layout = with_slot();
  const auto half = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(half, {50'000, 0}).put(half, {60'000, 0});
  const std::vector<PieceId> halves{{1}, {2}};
  const Containment result = contained(layout.marker(), halves, Box{{0, 0}, {30'000, 30'000}});
  ASSERT_EQ(result.verdict, Verdict::kFound);
  EXPECT_TRUE(is_valid(result.marker));
  EXPECT_EQ(result.length_after, 30'000);
}

TEST(Contain, PlacesUnplacedPiecesAndLeavesTheOthers) {
  test::Layout layout = with_slot();
  const auto half = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(half, {0, 0}).put(half, {0, 0}).put(half, {0, 0});
  Marker marker = layout.marker();
  marker.unplaced.assign(marker.pieces.begin() + 1, marker.pieces.end());
  marker.pieces.resize(1);
  const Box room{{0, 0}, {30'000, 30'000}};
  const Containment result =
      contained(marker, {bodies::unplaced_piece(marker, 2), bodies::unplaced_piece(marker, 0)}, room);
  ASSERT_EQ(result.verdict, Verdict::kFound);
  EXPECT_TRUE(is_valid(result.marker));
  ASSERT_EQ(result.marker.pieces.size(), 3U);
  EXPECT_EQ(result.marker.pieces[1].id, "p1");
  EXPECT_EQ(result.marker.pieces[2].id, "p3");
  ASSERT_EQ(result.marker.unplaced.size(), 1U);
  EXPECT_EQ(result.marker.unplaced[0], marker.unplaced[1]);
  const std::vector<PieceId> all{{1}, {2}, {3}};
  EXPECT_EQ(contained(marker, all, room).verdict, Verdict::kImpossible);
}

TEST(Contain, ProvesThatPiecesAreTooLarge) {
  test::Layout layout = with_slot();
  layout.put(layout.shape_of(test::rectangle(10'000, 10'010)), {50'000, 0});
  EXPECT_EQ(contained(layout.marker(), {{1}}, Box{{0, 0}, {30'000, 30'000}}).verdict, Verdict::kImpossible);
  layout = with_slot();
  layout.put(layout.shape_of(test::rectangle(20'010, 10'000)), {50'000, 0});
  EXPECT_EQ(contained(layout.marker(), {{1}}, Box{{0, 0}, {30'000, 30'000}}).verdict, Verdict::kImpossible);
}

// Any three of the bars fit, but no two of them beside each other.
TEST(Contain, RefusesAStackThatIsTooHighWithoutBranching) {
  for (const bool across : {false, true}) {
    test::Layout layout{40'000};
    const auto bar = layout.shape_of(across ? test::rectangle(8'000, 20'000) : test::rectangle(20'000, 8'000));
    for (int k = 0; k < 4; ++k) layout.put(bar, {50'000, 0});
    const Box room{{0, 0}, across ? Vec{31'000, 35'000} : Vec{35'000, 31'000}};
    EXPECT_EQ(contained(layout.marker(), {{0}, {1}, {2}}, room).verdict, Verdict::kFound);
    const Containment result = contained(layout.marker(), all_of(layout.marker()), room);
    EXPECT_EQ(result.verdict, Verdict::kImpossible);
    EXPECT_EQ(result.work.nodes, 0U);
  }
}

TEST(Contain, IsUndecidedAtTheWorkLimit) {
  test::Layout layout{31'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  for (int k = 0; k < 10; ++k) layout.put(square, {0, 0});
  ContainSettings settings;
  settings.limits.nodes = 2;
  const Containment result =
      contained(layout.marker(), all_of(layout.marker()), Box{{0, 0}, {31'000, 31'000}}, settings);
  EXPECT_EQ(result.verdict, Verdict::kUndecided);
  EXPECT_EQ(result.reason, scene::StopReason::kWorkLimit);
}

// Two squares that fit only because they may overlap each other, a piece that stays, or both.
TEST(Contain, TriesToUseOverlapAllowances) {
  test::Layout layout{100'000};
  const auto square = layout.shape_of(test::rectangle(51'000, 51'000));
  const auto post = layout.shape_of(test::rectangle(10'000, 100'000));
  layout.put(post, {20'000, 0}, 0, true).put(square, {200'000, 0}).put(square, {300'000, 0}).put(post, {85'000, 0});
  Marker marker = layout.marker();
  marker.overlap = 2'400;
  for (Shape& shape : marker.shapes) shape.rotations = {Angle{}};
  const std::vector<PieceId> squares{{1}, {2}};
  for (const Coord low : {30'000, 28'500}) {
    const Box room{{low, 0}, {80'000, 100'000}};
    const Containment result = contained(marker, squares, room);
    ASSERT_EQ(result.verdict, low == 30'000 ? Verdict::kUndecided : Verdict::kFound);
    EXPECT_EQ(result.reason, low == 30'000 ? scene::StopReason::kWorkLimit : scene::StopReason::kConverged);
    if (result.verdict != Verdict::kFound) continue;
    EXPECT_TRUE(is_valid(result.marker));
    EXPECT_EQ(result.marker.pieces[0], marker.pieces[0]);
    EXPECT_EQ(result.marker.pieces[3], marker.pieces[3]);
    EXPECT_EQ(result.marker.overlap, 2'400);
    const marker::PlacedPieces pieces{result.marker};
    for (const PieceId id : squares) EXPECT_TRUE(room.contains(pieces.box(id.value)));
  }
  // In a room with a corner cut off, too, and with pieces that were not placed.
  marker.unplaced.assign(marker.pieces.begin() + 1, marker.pieces.begin() + 3);
  marker.pieces.erase(marker.pieces.begin() + 1, marker.pieces.begin() + 3);
  for (Piece& piece : marker.unplaced) piece.locked = Locks{true, true, false};
  const Container cut{Polygon{{29'000, 0}, {85'000, 0}, {85'000, 95'000}, {81'000, 100'000}, {29'000, 100'000}}};
  const Containment placed =
      contained(marker, {bodies::unplaced_piece(marker, 0), bodies::unplaced_piece(marker, 1)}, cut);
  ASSERT_EQ(placed.verdict, Verdict::kFound);
  EXPECT_TRUE(is_valid(placed.marker));
  EXPECT_TRUE(placed.marker.unplaced.empty());
  EXPECT_EQ(placed.marker.pieces[2].locked, marker.unplaced[0].locked);
}

// Three pieces side by side fill a slanted channel that is a unit wider than they are: each of them has to give the
// others a part of that.
TEST(Contain, PlacesARowThatLeavesAUnitAcross) {
  test::Layout layout{20'000};
  const auto below = layout.shape_of({{0, 0}, {12'000, 0}, {12'000, 9'040}, {0, 5'000}});
  const auto above = layout.shape_of({{0, 6'501}, {12'000, 10'541}, {12'000, 20'000}, {0, 20'000}});
  const auto bar = layout.shape_of({{0, 0}, {3'000, 1'010}, {3'000, 1'510}, {0, 500}});
  layout.put(below, {0, 0}, 0, true)
      .put(above, {0, 0}, 0, true)
      .put(bar, {30'000, 0})
      .put(bar, {40'000, 0})
      .put(bar, {50'000, 0});
  const std::vector<PieceId> bars{{2}, {3}, {4}};
  const Containment result = contained(layout.marker(), bars, Box{{1'001, 0}, {4'502, 20'000}});
  ASSERT_EQ(result.verdict, Verdict::kFound);
  EXPECT_TRUE(is_valid(result.marker));
}

// Pieces far away change neither the answer nor the work, and stay.
TEST(Contain, LooksOnlyAtPiecesNearTheRoom) {
  test::Layout layout = with_slot();
  const auto half = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(half, {50'000, 0}).put(half, {60'000, 0});
  const std::vector<PieceId> halves{{1}, {2}};
  const Box room{{0, 0}, {30'000, 30'000}};
  const Containment near = contained(layout.marker(), halves, room);
  for (int k = 0; k < 40; ++k) layout.put(half, {200'000 + 10'000 * k, 0});
  const Marker marker = layout.marker();
  const Containment all = contained(marker, halves, room);
  ASSERT_EQ(all.verdict, Verdict::kFound);
  EXPECT_TRUE(is_valid(all.marker));
  EXPECT_EQ(all.work.nodes, near.work.nodes);
  EXPECT_EQ(all.work.looks, near.work.looks);
  ASSERT_EQ(all.marker.pieces.size(), marker.pieces.size());
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    EXPECT_EQ(all.marker.pieces[k], k < near.marker.pieces.size() ? near.marker.pieces[k] : marker.pieces[k]);
  }
}

// An arrow to the right: its tip and the two sides of its shaft leave walls with slanted and with upright borders.
Polygon arrow() {
  return {{0, 10'000},      {40'000, 10'000}, {40'000, 0}, {60'000, 20'000},
          {40'000, 40'000}, {40'000, 30'000}, {0, 30'000}};
}

TEST(Contain, KeepsToAPolygon) {
  test::Layout layout{100'000};
  const auto bar = layout.shape_of(test::rectangle(40'000, 20'000));
  const auto corner = layout.shape_of({{0, 0}, {20'000, 20'000}, {0, 40'000}});
  layout.put(bar, {0, 0}).put(corner, {0, 0});
  const Marker marker = layout.marker();
  const Containment both = contained(marker, all_of(marker), Container{arrow()});
  ASSERT_EQ(both.verdict, Verdict::kFound);
  EXPECT_EQ(both.marker.pieces[0].at, (Vec{0, 10'000}));
  EXPECT_EQ(both.marker.pieces[1].at, (Vec{40'000, 0}));
  // The same piece has much room in the box of the arrow, and none in a slightly smaller arrow.
  Polygon smaller = arrow();
  smaller[3].x -= 10;
  EXPECT_EQ(contained(marker, all_of(marker), Container{smaller}).verdict, Verdict::kImpossible);
  EXPECT_EQ(contained(marker, all_of(marker), Container{box_of(arrow())}).verdict, Verdict::kFound);
}

TEST(Contain, KeepsToThePolygonInTheFreeSpaceBetweenFixedPieces) {
  test::Layout layout{100'000};
  const auto block = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(block, {20'000, 10'000}).put(block, {0, 0}).put(block, {0, 0}).put(block, {0, 0});
  const Marker marker = layout.marker();
  Polygon shaft = arrow();
  const std::vector<PieceId> two{{1}, {2}};
  const Containment result = contained(marker, two, Container{shaft});
  ASSERT_EQ(result.verdict, Verdict::kFound);
  EXPECT_EQ(result.marker.pieces[0], marker.pieces[0]);
  for (const PieceId piece : two) {
    for (const Vec corner : placed_outline(result.marker, piece)) {
      EXPECT_NE(geometry::locate(corner, shaft), geometry::Location::kOutside);
    }
  }
}

// The walls and the polygon together cover the box exactly once.
TEST(Container, HasWallsForEverythingOutsideThePolygon) {
  test::Random random{67};
  for (int trial = 0; trial < 200 / test::kSlowdown; ++trial) {
    Polygon star;
    const int corners = 3 + static_cast<int>(random.below(9));
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5 * random.part()) / corners;
      const double radius = 20 + 1000 * random.part();
      star.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
    }
    const auto clean = geometry::clean_polygon(star);
    if (!clean) continue;
    const Container container{clean->polygon};
    auto area = doubled_area(clean->polygon);
    for (const Polygon& wall : container.walls) {
      EXPECT_GT(doubled_area(wall), 0);
      EXPECT_FALSE(geometry::overlap({wall, box_of(wall), {}}, {clean->polygon, container.box, {}}));
      area += doubled_area(wall);
    }
    EXPECT_EQ(area, 2 * geometry::Wide{container.box.width()} * container.box.height()) << "trial " << trial;
  }
}

TEST(Contain, FindsTheLayoutWithMostRoom) {
  test::Layout layout{100'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(square, {0, 0}).put(square, {0, 0});
  const Marker marker = layout.marker();
  SumCache sums;
  // Three gaps of 10 mm beside two squares along the room, or of 15 mm across it.
  const auto roomy = contain_with_most_room(marker, all_of(marker), Box{{0, 0}, {50'000, 40'000}}, {}, {sums});
  ASSERT_EQ(roomy.verdict, Verdict::kFound);
  EXPECT_TRUE(is_valid(roomy.marker));
  EXPECT_EQ(roomy.marker.spacing, 0);
  EXPECT_EQ(roomy.marker.pieces[0].buffer, 0);
  EXPECT_GT(roomy.clearance, 9'800);
  ASSERT_TRUE(roomy.clearance_bound);
  EXPECT_GT(*roomy.clearance_bound, roomy.clearance);
  EXPECT_LT(*roomy.clearance_bound, roomy.clearance * 65 / 64 + 16);
  const Vec between = roomy.marker.pieces[1].at - roomy.marker.pieces[0].at;
  const double gap =
      std::hypot(std::max<Coord>(0, std::abs(between.x) - 10'000), std::max<Coord>(0, std::abs(between.y) - 10'000));
  EXPECT_GE(gap, static_cast<double>(roomy.clearance));
  const auto none = contain_with_most_room(marker, all_of(marker), Box{{0, 0}, {15'000, 15'000}}, {}, {sums});
  EXPECT_EQ(none.verdict, Verdict::kImpossible);
  EXPECT_EQ(none.marker, marker);
}

TEST(Contain, PiecesThatCannotMoveHaveToFitWhereTheyLie) {
  test::Layout layout{100'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(square, {12'000, 12'000}, 0, true).put(square, {62'000, 12'000}, 0, true).put(square, {0, 60'000});
  const Marker marker = layout.marker();
  EXPECT_EQ(contained(marker, {{0}, {2}}, Box{{0, 0}, {40'000, 40'000}}).verdict, Verdict::kFound);
  EXPECT_EQ(contained(marker, {{0}, {2}}, Box{{15'000, 0}, {60'000, 40'000}}).verdict, Verdict::kImpossible);
  const Container triangle{Polygon{{0, 0}, {30'000, 0}, {0, 30'000}}};
  EXPECT_EQ(contained(marker, {{0}}, triangle).verdict, Verdict::kImpossible);
  SumCache sums;
  ContainSettings settings;
  settings.limits.nodes = 1'000;
  const auto roomy =
      contain_with_most_room(marker, std::vector<PieceId>{{0}}, Box{{0, 0}, {60'000, 60'000}}, settings, {sums});
  ASSERT_EQ(roomy.verdict, Verdict::kFound);
  EXPECT_EQ(roomy.reason, scene::StopReason::kConverged);
  EXPECT_EQ(roomy.marker, marker);
  EXPECT_GT(roomy.clearance, 11'800);
  EXPECT_LE(roomy.clearance, 12'000);
}

TEST(Contain, NamesPiecesThatStayAndBreakARule) {
  test::Layout layout = with_slot();
  const auto half = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(half, {50'000, 0}).put(half, {59'000, 0}).put(half, {52'000, 5'000});
  const Marker marker = layout.marker();
  EXPECT_FALSE(defect_of_staying(marker, std::vector<PieceId>{{1}, {2}})) << "two of the three go elsewhere";
  const auto overlapping = defect_of_staying(marker, std::vector<PieceId>{{1}});
  ASSERT_TRUE(overlapping);
  EXPECT_EQ(overlapping->code, ErrorCode::kMarkerOverlaps);
  EXPECT_NE(overlapping->message.find("\"p2\" and \"p3\""), std::string::npos) << overlapping->message;

  Marker grouped = marker;
  grouped.pieces[1].group = grouped.pieces[2].group = "halves";
  EXPECT_FALSE(defect_of_staying(grouped, std::vector<PieceId>{{1}})) << "its group goes with it";
  Marker outside = marker;
  outside.pieces[3].at = {80'000, 25'000};
  const auto protruding = defect_of_staying(outside, std::vector<PieceId>{{1}, {bodies::unplaced_piece(marker, 0)}});
  ASSERT_TRUE(protruding);
  EXPECT_EQ(protruding->code, ErrorCode::kOutsideStrip);
}

TEST(Contain, KeepsTheStripsMarginsAndTheSpacing) {
  test::Layout layout{12'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(square, {0, 0}).put(square, {30'000, 0}).spaced(1000);
  Marker marker = layout.marker();
  marker.strip.margin = 1000;
  const Box exact{{0, 0}, {22'000, 12'000}};
  const Containment found = contained(marker, all_of(marker), exact);
  ASSERT_EQ(found.verdict, Verdict::kFound);
  EXPECT_TRUE(is_valid(found.marker));
  const Box tight{{0, 0}, {21'990, 12'000}};
  EXPECT_EQ(contained(marker, all_of(marker), tight).verdict, Verdict::kImpossible);
}

TEST(Contain, AgreesWithExhaustiveSearchOnAGrid) {
  test::Random random{20'261'122};
  int possible = 0;
  constexpr int kTrials = 300 / test::kSlowdown;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Coord width = random.between(3, 5);
    const Coord length = random.between(3, 6);
    std::vector<test::Squares> pieces;
    for (Coord area = 0; area * 10 < width * length * 7;) {
      pieces.push_back(test::random_squares(random, 1 + random.below(6)));
      area += static_cast<Coord>(pieces.back().size());
    }
    bool narrow = true;
    for (const auto& squares : pieces) narrow = narrow && box_of(squares).high.y < width;
    if (!narrow) continue;
    const Marker marker = test::marker_of(pieces, width);
    const Box room{{0, 0}, {length * test::kSquare, width * test::kSquare}};
    ContainSettings settings;
    settings.turns = false;
    const Containment result = contained(marker, all_of(marker), room, settings);
    const bool fits = test::fit_on_grid(pieces, width, length);
    EXPECT_EQ(result.verdict, fits ? Verdict::kFound : Verdict::kImpossible) << "trial " << trial;
    if (result.verdict == Verdict::kFound) {
      EXPECT_TRUE(is_valid(result.marker)) << "trial " << trial;
    }
    possible += fits ? 1 : 0;
  }
  EXPECT_GT(possible, kTrials / 10);
  EXPECT_LT(possible, kTrials * 9 / 10);
}

}  // namespace
}  // namespace selvage::packing
