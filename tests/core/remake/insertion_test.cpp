#include "core/remake/insertion.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"
#include "tests/laws/random_marker.h"

namespace selvage::remake {
namespace {

// A hole of 10 by 10 between four blocks.
Marker with_room() {
  test::Layout layout{50'000};
  const auto lying = layout.shape_of(test::rectangle(60'000, 20'000));
  const auto post = layout.shape_of(test::rectangle(25'000, 10'000));
  layout.put(lying, {0, 0}).put(lying, {0, 30'000}).put(post, {0, 20'000}).put(post, {35'000, 20'000});
  return layout.marker();
}

Piece square(Marker& marker, Coord side, const std::string& id) {
  Shape shape;
  shape.id = id;
  shape.outline = test::rectangle(side, side);
  marker.shapes.push_back(shape);
  Piece piece;
  piece.id = id;
  piece.shape = ShapeId{static_cast<std::uint32_t>(marker.shapes.size() - 1)};
  return piece;
}

TEST(Insertion, UsesRoomBeforeTheMarkerGrows) {
  Marker marker = with_room();
  marker.unplaced = {square(marker, 9'000, "small"), square(marker, 12'000, "large")};
  SumCache sums;
  EXPECT_EQ(insert_unplaced(marker, {}, scene::Run{sums}), 1U);
  ASSERT_TRUE(marker.unplaced.empty());
  EXPECT_TRUE(is_valid(marker));
  EXPECT_EQ(marker.pieces[4].id, "large");
  EXPECT_EQ(length_of(marker), 72'000);
  EXPECT_EQ(marker.pieces[5].at.y / 1'000, 20);
}

TEST(Insertion, ReturnsAPieceToItsHomeWhenThatIsFree) {
  Marker marker = with_room();
  const Piece small = square(marker, 9'000, "small");
  Piece at_home = small;
  at_home.at = {25'500, 20'500};
  marker.unplaced = {small};
  SumCache sums;
  EXPECT_EQ(insert_unplaced(marker, {{"small", at_home}}, scene::Run{sums}), 1U);
  EXPECT_EQ(marker.pieces.back().at, at_home.at);
}

TEST(Insertion, LeavesOutPiecesThatAreTooWide) {
  Marker marker = with_room();
  marker.unplaced = {square(marker, 51'000, "wide")};
  SumCache sums;
  EXPECT_EQ(insert_unplaced(marker, {}, scene::Run{sums}), 0U);
  EXPECT_EQ(marker.unplaced.size(), 1U);
}

TEST(Insertion, KeepsRandomMarkersValid) {
  test::Random random{11};
  for (int trial = 0; trial < 20 / test::kSlowdown + 1; ++trial) {
    Marker marker = test::random_marker(random);
    const Marker before = marker;
    while (marker.pieces.size() > 1 && random.chance(60)) {
      marker.unplaced.push_back(marker.pieces.back());
      marker.pieces.pop_back();
    }
    const std::size_t kept = marker.pieces.size();
    SumCache sums;
    (void)insert_unplaced(marker, {}, scene::Run{sums});
    EXPECT_TRUE(is_valid(marker));
    for (std::size_t k = 0; k < kept; ++k) EXPECT_EQ(marker.pieces[k], before.pieces[k]);
    EXPECT_EQ(marker.pieces.size() + marker.unplaced.size(), before.pieces.size());
  }
}

TEST(Insertion, DoesNothingWhenStopped) {
  Marker marker = with_room();
  marker.unplaced = {square(marker, 9'000, "small")};
  SumCache sums;
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(insert_unplaced(marker, {}, scene::Run{sums, stop.get_token()}), 0U);
  EXPECT_EQ(marker.unplaced.size(), 1U);
}

}  // namespace
}  // namespace selvage::remake
