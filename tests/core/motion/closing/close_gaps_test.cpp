// Bodies of pieces that nothing holds on their left, such as the second of two markers that lie one behind the other.
#include "core/motion/closing/close_gaps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "tests/core/motion/markers.h"
#include "tests/support/garment.h"

namespace selvage::motion::closing {
namespace {

using test::Layout;

// The marker, and behind a gap the same marker again.
Marker with_copy_behind(const Marker& marker, Coord gap) {
  Marker both = marker;
  for (const Piece& piece : marker.pieces) {
    both.pieces.push_back(piece);
    both.pieces.back().id += " again";
    both.pieces.back().at.x += length_of(marker) + gap;
  }
  return both;
}

struct Closed {
  bool moved{};
  std::vector<Vec> by;  // one per piece
  Coord length{};
};
Closed closed(const Marker& marker) {
  SumCache sums;
  scene::Scene scene{marker, sums};
  EXPECT_TRUE(is_valid(marker));
  Closed result;
  result.moved = close_gaps(scene, marker.strip.width / 10, 64, {sums});
  EXPECT_TRUE(is_valid(scene.result()));
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) result.by.push_back(scene.pieces.at(k) - marker.pieces[k].at);
  result.length = scene.pieces.length();
  return result;
}

TEST(CloseGaps, TheSecondOfTwoMarkersMovesToTheFirst) {
  const Marker one = test::garment("jeans_06g");
  const Coord width = one.strip.width;
  const Marker marker = with_copy_behind(one, 3 * width);
  const Closed result = closed(marker);
  ASSERT_TRUE(result.moved);
  const std::size_t half = one.pieces.size();
  for (std::size_t k = 0; k < half; ++k) {
    EXPECT_EQ(result.by[k], Vec{});
    EXPECT_EQ(result.by[half + k], result.by.back());
  }
  EXPECT_EQ(result.by.back().y, 0);
  EXPECT_LT(result.length, 2 * length_of(one) + width / 10);
}

// Pieces behind the gap used to move on top of those before it; programs grew by hundreds of pairs, and took minutes.
TEST(CloseGaps, AGapMakesProgramsHardlyLarger) {
  const Marker one = test::garment("simon_06g");
  const auto largest_program = [](const Marker& marker) {
    SumCache sums;
    int rows = 0;
    scene::Run run{sums};
    run.observer.on_program = [&](const lp::LinearProgram& program) { rows = std::max(rows, program.rows()); };
    EXPECT_TRUE(compaction::compact(marker, compaction_settings(compaction::Accuracy::kStandard), run));
    return rows;
  };
  EXPECT_LT(largest_program(with_copy_behind(one, 2 * one.strip.width)),
            1.1 * largest_program(with_copy_behind(one, 0)));
}

// Rows of squares that touch, `columns` of them, from `x` on.
void put_block(Layout& layout, std::uint32_t square, Coord x, int columns, Coord pitch) {
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < 8; ++r) layout.put(square, {x + c * pitch, r * pitch});
  }
}

TEST(CloseGaps, FewPiecesStayForTheRounds) {
  Layout layout{800'000};
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  put_block(layout, square, 0, 1, 100'000);
  put_block(layout, square, 3'000'000, 7, 100'000);
  EXPECT_FALSE(closed(layout.marker()).moved);
  put_block(layout, square, 3'700'000, 1, 100'000);
  EXPECT_TRUE(closed(layout.marker()).moved);
}

TEST(CloseGaps, EveryBodyMovesUntilItIsNearAnother) {
  Layout layout{960'000};
  layout.spaced(20'000);
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  for (const Coord x : {500'000, 3'000'000, 9'000'000}) put_block(layout, square, x, 4, 120'000);
  EXPECT_NEAR(static_cast<double>(closed(layout.marker()).length), 12 * 120'000 - 20'000, 100);
}

TEST(CloseGaps, AFixedPieceHoldsItsBody) {
  Marker marker = with_copy_behind(test::garment("jeans_06g"), 2 * test::garment("jeans_06g").strip.width);
  marker.pieces.back().locked.x = true;
  EXPECT_FALSE(closed(marker).moved);
}

TEST(CloseGaps, APieceThatIsMatchedToThePatternHoldsItsBody) {
  Layout layout{800'000};
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  put_block(layout, square, 0, 8, 100'000);
  put_block(layout, square, 3'000'000, 8, 100'000);
  Marker marker = layout.marker();
  EXPECT_TRUE(closed(marker).moved);
  marker.strip.repeat.along = 30'000;
  marker.pieces.back().rules.match = Vec{20'000, 0};  // at x = 3,720,000, where a repeat begins
  EXPECT_FALSE(closed(marker).moved);
}

TEST(CloseGaps, LoosePiecesNeverCollide) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Marker marker = test::loose_marker(seed, 14, 6);
    for (Piece& piece : marker.pieces) piece.at.x += piece.at.x * static_cast<Coord>(seed % 4) + 400'000;
    const Closed result = closed(marker);
    EXPECT_TRUE(result.moved) << seed;
    for (const Vec& by : result.by) {
      EXPECT_LE(by.x, 0);
      EXPECT_EQ(by.y, 0);
    }
  }
}

}  // namespace
}  // namespace selvage::motion::closing
