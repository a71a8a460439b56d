#include "core/remake/overlap_removal.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"
#include "tests/laws/random_marker.h"
#include "tests/support/garment.h"

namespace selvage::remake {
namespace {

TEST(OverlapRemoval, DoesNotChangeAValidMarker) {
  const Marker marker = test::garment("jeans_02g");
  SumCache sums;
  const auto apart = remove_overlaps(marker, {}, scene::Run{sums});
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->by, RemovedBy::kNothing);
  EXPECT_EQ(apart->marker, marker);
}

TEST(OverlapRemoval, SeparatesSmallOverlaps) {
  test::Random random{12};
  for (int trial = 0; trial < 10 / test::kSlowdown + 1; ++trial) {
    Marker marker = test::perturbed(random, test::random_marker(random), 0.03);
    marker.strip.longest.reset();
    for (Piece& piece : marker.pieces) piece.locked = {};
    marker.unplaced.push_back(marker.pieces.front());  // is left as it is
    marker.unplaced.back().id = "unplaced";
    SumCache sums;
    const auto apart = remove_overlaps(marker, {}, scene::Run{sums});
    ASSERT_TRUE(apart);
    EXPECT_TRUE(is_valid(apart->marker));
    EXPECT_EQ(apart->marker.pieces.size(), marker.pieces.size());
    EXPECT_EQ(apart->marker.unplaced, marker.unplaced);
  }
}

// Two blocks and a trim between them are higher than the strip, so the trim must be moved elsewhere.
TEST(OverlapRemoval, PopsTheTrimOfAColumnThatIsTooTall) {
  test::Layout layout{50'000};
  const auto block = layout.shape_of(test::rectangle(40'000, 22'000));
  const auto trim = layout.shape_of(test::rectangle(6'000, 7'000));
  const auto wall = layout.shape_of(test::rectangle(3'000, 50'000));
  layout.put(wall, {0, 0}).put(block, {3'000, 0}).put(block, {3'000, 28'000}).put(trim, {17'000, 21'500});
  layout.put(wall, {43'000, 0});
  Marker marker = layout.marker();
  SumCache sums;
  RemakeTuning tuning;
  tuning.searches = 0;
  tuning.growth = 0.02;
  const auto apart = remove_overlaps(marker, tuning, scene::Run{sums});
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->by, RemovedBy::kPopping);
  EXPECT_EQ(apart->popped, 1U);
  EXPECT_TRUE(is_valid(apart->marker));
  EXPECT_EQ(apart->marker.pieces.size(), marker.pieces.size());
}

// Two columns of three blocks that two of them fill.
Marker two_tall_columns() {
  test::Layout layout{50'000};
  const auto block = layout.shape_of(test::rectangle(20'000, 24'000));
  for (int k = 0; k < 3; ++k) layout.put(block, {0, 12'000 * k}).put(block, {20'000, 12'000 * k});
  return layout.marker();
}

// Separation and popping do not help.
RemakeTuning only_search() {
  RemakeTuning tuning;
  tuning.growth = 0;
  tuning.first_pops = 0;
  tuning.search_growth = 0.2;
  return tuning;
}

// The pieces as the search has parted them, which has to be needed.
std::vector<Piece> parted_by_search(const Marker& marker) {
  SumCache sums;
  const auto apart = remove_overlaps(marker, only_search(), scene::Run{sums});
  if (!apart) {
    ADD_FAILURE() << "the pieces still overlap";
    return {};
  }
  EXPECT_EQ(apart->by, RemovedBy::kSearch);
  EXPECT_TRUE(is_valid(apart->marker));
  EXPECT_EQ(apart->marker.pieces.size(), marker.pieces.size());
  return apart->marker.pieces;
}

// Without popping, only another arrangement has room.
TEST(OverlapRemoval, SearchesWhereNothingElseHelps) {
  EXPECT_FALSE(parted_by_search(two_tall_columns()).empty());
}

// Three blocks across the strip that lie a little on each other.
TEST(OverlapRemoval, LengthensTheMarkerByWhatFewOverlapsNeed) {
  test::Layout layout{50'000};
  const auto block = layout.shape_of(test::rectangle(20'000, 50'000));
  const Marker marker = layout.put(block, {0, 0}).put(block, {19'000, 0}).put(block, {38'000, 0}).marker();
  SumCache sums;
  RemakeTuning tuning = only_search();
  tuning.first_growth = 0;
  tuning.searches = 2;  // the first of them in the marker's own length
  tuning.search_growth = 0.001;
  tuning.pops = 0;
  tuning.few_overlaps = 0;
  EXPECT_FALSE(remove_overlaps(marker, tuning, scene::Run{sums}));
  tuning.few_overlaps = 1;
  const auto apart = remove_overlaps(marker, tuning, scene::Run{sums});
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->by, RemovedBy::kSearch);
  EXPECT_TRUE(is_valid(apart->marker));
}

TEST(OverlapRemoval, DoesNotSearchWhenItIsToBeQuick) {
  const Marker marker = two_tall_columns();
  SumCache sums;
  EXPECT_TRUE(remove_overlaps(marker, only_search(), scene::Run{sums}));
  EXPECT_FALSE(remove_overlaps(marker, only_search(), scene::Run{sums}, Removal::kQuick));
}

// The stored marker's tilts are part of what makes it dense.
TEST(OverlapRemoval, KeepsTiltsWhileItSearches) {
  Marker marker = two_tall_columns();
  for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(2);
  for (Piece& piece : marker.pieces) piece.orientation.tilt = Angle::of_degrees(1);
  for (const Piece& piece : parted_by_search(marker)) {
    EXPECT_EQ(piece.orientation.tilt, Angle::of_degrees(1));
    EXPECT_EQ(piece.locked, Locks{});
  }
}

TEST(OverlapRemoval, PopsMorePiecesWhereTheSearchFails) {
  const Marker marker = two_tall_columns();
  SumCache sums;
  RemakeTuning tuning = only_search();
  tuning.searches = 0;
  const auto apart = remove_overlaps(marker, tuning, scene::Run{sums});
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->by, RemovedBy::kPopping);
  EXPECT_GT(apart->popped, 0U);
  EXPECT_TRUE(is_valid(apart->marker));
  tuning.pops = 0;
  EXPECT_FALSE(remove_overlaps(marker, tuning, scene::Run{sums}));
}

TEST(OverlapRemoval, ReturnsNothingWhenCancelled) {
  test::Random random{13};
  const Marker marker = test::perturbed(random, test::garment("jeans_02g"), 0.05);
  SumCache sums;
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(remove_overlaps(marker, {}, scene::Run{sums, stop.get_token()}));
}

}  // namespace
}  // namespace selvage::remake
