#include "core/remake/popping.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"
#include "tests/laws/random_marker.h"

namespace selvage::remake {
namespace {

std::optional<Popping> popped(const Marker& marker, const substitution::RemakeTuning& tuning = {},
                              std::size_t most = 6) {
  SumCache sums;
  return apart_by_popping(marker, most, tuning, scene::Run{sums});
}

// Between two walls, three panels of a third of the strip's width each, the last a little higher.
Marker tall_column(Coord excess, Coord room) {
  test::Layout layout{51'000};
  const auto wall = layout.shape_of(test::rectangle(3'000, 51'000));
  const auto panel = layout.shape_of(test::rectangle(40'000, 17'000));
  const auto tall = layout.shape_of(test::rectangle(20'000, 17'000 + excess));
  layout.put(wall, {0, 0}).put(panel, {3'000, 0}).put(panel, {3'000, 17'000}).put(tall, {3'000, 34'000 - excess});
  layout.put(wall, {43'000, 0}).put(wall, {46'000 + room, 0});
  return layout.marker();
}

TEST(Popping, KeepsPiecesThatSeparationCanSeparate) {
  Marker marker = tall_column(0, 0);
  marker.pieces[3].at.x += 500;
  marker.pieces[3].at.y -= 500;
  const auto apart = popped(marker);
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->popped, 0U);
  EXPECT_TRUE(is_valid(apart->marker));
}

TEST(Popping, PutsAPanelWhereThereIsRoom) {
  const Marker marker = tall_column(500, 21'000);
  substitution::RemakeTuning tuning;
  tuning.growth = 0;
  const auto apart = popped(marker, tuning);
  ASSERT_TRUE(apart);
  EXPECT_GE(apart->popped, 1U);
  EXPECT_TRUE(is_valid(apart->marker));
  EXPECT_LE(length_of(apart->marker), length_of(marker));
}

// The gap is slightly too short for any of the panels.  The wall behind it is pushed away when the piece is restored
// there.
TEST(Popping, RestoresAPieceThatWasPutBackShrunken) {
  const Marker marker = tall_column(500, 19'000);
  substitution::RemakeTuning tuning;
  tuning.growth = 0.05;
  const auto apart = popped(marker, tuning);
  ASSERT_TRUE(apart);
  EXPECT_GE(apart->popped, 1U);
  EXPECT_TRUE(is_valid(apart->marker));
  EXPECT_LE(length_of(apart->marker), length_of(marker) + 2'000);  // at the end it would take 20,000 more
}

TEST(Popping, GivesUpBeyondTheLimitOfPieces) {
  substitution::RemakeTuning tuning;
  tuning.growth = 0;
  EXPECT_TRUE(popped(tall_column(500, 0), tuning, 1));
  EXPECT_FALSE(popped(tall_column(500, 0), tuning, 0));
}

TEST(Popping, KeepsPiecesAndTheirSequence) {
  test::Random random{21};
  for (int trial = 0; trial < 10 / test::kSlowdown + 1; ++trial) {
    Marker marker = test::perturbed(random, test::random_marker(random), 0.1);
    marker.strip.longest.reset();
    marker.unplaced.clear();
    for (Piece& piece : marker.pieces) piece.locked = {};
    const auto apart = popped(marker);
    if (!apart) continue;
    EXPECT_TRUE(is_valid(apart->marker));
    ASSERT_EQ(apart->marker.pieces.size(), marker.pieces.size());
    EXPECT_EQ(apart->marker.shapes, marker.shapes);
    for (std::size_t k = 0; k < marker.pieces.size(); ++k) EXPECT_EQ(apart->marker.pieces[k].id, marker.pieces[k].id);
  }
}

}  // namespace
}  // namespace selvage::remake
