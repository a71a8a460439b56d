// Extreme layouts: without any free room, with as many pieces in a chain as are allowed, of a single piece, and of
// pieces as wide as the strip.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/marker/validity.h"
#include "protocol/formats/format.h"
#include "tests/core/motion/markers.h"
#include "tests/extremes/reached.h"
#include "tests/extremes/soundness.h"

namespace selvage::test {
namespace {

using test::Layout;
using test::reached;
using test::soundly_compacted;

// Expects a compaction without gain: it converges, and the length is unchanged.
void expect_full(const Marker& marker) {
  const motion::compaction::Compaction result = soundly_compacted(marker);
  EXPECT_EQ(result.reason, scene::StopReason::kConverged);
  EXPECT_EQ(result.length_after, result.length_before);
  EXPECT_EQ(result.repair.pairs, 0U);
  reached("pieces without room", static_cast<double>(marker.pieces.size()));
  reached("utilisation", result.utilisation_after);
}

TEST(ExtremeLayouts, Bricks) {
  constexpr Coord kWide = 1'000'003;  // primes, so that no two lengths have a common divisor
  constexpr Coord kHigh = 300'007;
  Layout layout{11 * kHigh};
  const auto brick = layout.shape_of(test::rectangle(2 * kWide, kHigh));
  const auto half = layout.shape_of(test::rectangle(kWide, kHigh));
  for (Coord row = 0; row < 11; ++row) {
    const Coord offset = row % 2 == 0 ? 0 : kWide;
    if (offset > 0) layout.put(half, {0, row * kHigh}).put(half, {41 * kWide, row * kHigh});
    for (Coord k = 0; k < (offset > 0 ? 20 : 21); ++k) layout.put(brick, {offset + 2 * kWide * k, row * kHigh});
  }
  EXPECT_DOUBLE_EQ(marker::utilisation_of(layout.marker()), 1);
  expect_full(layout.marker());
}

TEST(ExtremeLayouts, Hexagons) {
  constexpr Coord kHalf = 1'000'000;  // half the length of a side
  const Coord height = std::llround(std::sqrt(3.0) * static_cast<double>(kHalf));
  Layout layout{2 * height * 8 + height};
  const auto hexagon = layout.shape_of(
      {{kHalf, 0}, {3 * kHalf, 0}, {4 * kHalf, height}, {3 * kHalf, 2 * height}, {kHalf, 2 * height}, {0, height}});
  for (Coord column = 0; column < 20; ++column) {
    for (Coord row = 0; row < 8; ++row) {
      layout.put(hexagon, {3 * kHalf * column, 2 * height * row + (column % 2) * height});
    }
  }
  expect_full(layout.marker());
}

TEST(ExtremeLayouts, Chevrons) {
  constexpr Coord kLength = 10'000'000;
  constexpr Coord kHeight = 700'001;
  constexpr Coord kDip = 333'333;
  Layout layout{60 * kHeight + kDip};
  const auto chevron = layout.shape_of(test::chevron(kLength, kHeight, kDip));
  for (Coord k = 0; k < 60; ++k) layout.put(chevron, {0, k * kHeight}).put(chevron, {kLength, k * kHeight});
  expect_full(layout.marker());
}

// A jigsaw of `grid` x `grid` squares whose corners are at thirds of a millimetre, which no lattice represents exactly.
// Its tabs are dovetails, or wedges that do not interlock.  With `local`, each piece has its own coordinates, so
// outline and position are rounded separately; otherwise all use the strip's coordinates, so common corners are rounded
// alike.
std::string jigsaw_in_thirds(int grid, bool local, bool dovetailed) {
  const auto third = [](int thirds) { return Json(thirds / 3.0); };
  constexpr int kSide = 100;
  Json document{{"format", "selvage-marker"}, {"version", 1}, {"strip", {{"width", grid * kSide / 3.0}}}};
  document["shapes"] = document["pieces"] = Json::array();
  for (int column = 0; column < grid; ++column) {
    for (int row = 0; row < grid; ++row) {
      const int x = column * kSide;
      const int y = row * kSide;
      std::vector<std::pair<int, int>> tab{{0, 41}, {13, 35}, {13, 65}, {0, 59}};  // wider at its end than at its neck
      if (!dovetailed) tab = {{0, 41}, {13, 50}, {0, 59}};
      std::vector<std::pair<int, int>> corners{{x, y}, {x + kSide, y}};
      if (column + 1 < grid) {
        for (const auto& [dx, dy] : tab) corners.emplace_back(x + kSide + dx, y + dy);
      }
      corners.emplace_back(x + kSide, y + kSide);
      corners.emplace_back(x, y + kSide);
      std::reverse(tab.begin(), tab.end());
      if (column > 0) {
        for (const auto& [dx, dy] : tab) corners.emplace_back(x + dx, y + dy);
      }
      const std::string id = std::to_string(column) + "-" + std::to_string(row);
      Json outline = Json::array();
      for (const auto& [px, py] : corners)
        outline.push_back({third(px - (local ? x : 0)), third(py - (local ? y : 0))});
      document["shapes"].push_back({{"id", id}, {"outline", outline}});
      document["pieces"].push_back({{"id", id}, {"shape", id}, {"at", {third(local ? x : 0), third(local ? y : 0)}}});
    }
  }
  return protocol::json::to_text(document);
}

TEST(ExtremeLayouts, AJigsawWhoseCornersAreThirds) {
  const auto read = protocol::formats::read_marker(jigsaw_in_thirds(10, false, true));
  ASSERT_TRUE(read) << read.error().field << ' ' << read.error().message;
  expect_full(read->marker);
}

// Outlines and positions are rounded separately, so pieces overlap by a unit and the marker has to grow by some units.
TEST(ExtremeLayouts, AJigsawWhosePlacesAreThirdsTooIsHealed) {
  const auto read = protocol::formats::read_marker(jigsaw_in_thirds(10, true, false));
  ASSERT_TRUE(read) << read.error().field << ' ' << read.error().message;
  const Marker& marker = read->marker;
  EXPECT_FALSE(is_valid(marker));
  const motion::compaction::Compaction result = soundly_compacted(marker);
  reached("overlapping pairs", static_cast<double>(result.repair.pairs));
  reached("lengthened, lattice units", static_cast<double>(result.repair.lengthened));
  EXPECT_LE(result.repair.lengthened, 40);
}

// A dovetail one unit too large for its slot could only be separated by moving it out of the slot, so the marker is
// rejected with the depth of that move.
TEST(ExtremeLayouts, DovetailsAUnitTooLargeAreRefusedByName) {
  const auto read = protocol::formats::read_marker(jigsaw_in_thirds(10, true, true));
  ASSERT_TRUE(read) << read.error().field << ' ' << read.error().message;
  const Marker before = read->marker;
  SumCache sums;
  const auto refused = compact(read->marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
  ASSERT_FALSE(refused);
  EXPECT_EQ(read->marker, before);
  EXPECT_EQ(refused.error().code, ErrorCode::kMarkerOverlaps);
  EXPECT_EQ(refused.error().field, "/pieces");
  for (const char* said : {"0.0333333 mm that is repaired", "\"0-0\" and \"1-0\" by 4.33333 mm"}) {
    EXPECT_NE(refused.error().message.find(said), std::string::npos) << refused.error().message;
  }
  reached("refused", "marker.overlaps, 4.33 mm deep");
}

// Each piece pushes the next, and all gaps close completely in one compaction.
TEST(ExtremeLayouts, TenThousandPiecesInOneChain) {
  constexpr Coord kSide = 1'000'000;
  constexpr Coord kGap = 1'234;
  constexpr Coord kPieces = 10'000;
  Layout layout{kSide};
  const auto square = layout.shape_of(test::rectangle(kSide, kSide));
  for (Coord k = 0; k < kPieces; ++k) layout.put(square, {k * (kSide + kGap), 0});
  const motion::compaction::Compaction result = soundly_compacted(layout.marker());
  EXPECT_EQ(result.length_after, kPieces * kSide);
  reached("pieces", static_cast<double>(kPieces));
  reached("rounds", result.rounds);
}

// The same for pieces that touch along slanted edges, where every contact may lose at most one unit to rounding.
TEST(ExtremeLayouts, AThousandSlantedPiecesInOneChain) {
  constexpr Coord kSide = 1'000'000;
  constexpr Coord kLean = 333'331;
  constexpr Coord kPieces = 1'000;
  Layout layout{kSide};
  const auto slanted = layout.shape_of({{0, 0}, {kSide, 0}, {kSide + kLean, kSide}, {kLean, kSide}});
  for (Coord k = 0; k < kPieces; ++k) layout.put(slanted, {k * (kSide + 1'234), 0});
  const motion::compaction::Compaction result = soundly_compacted(layout.marker());
  const Coord lost = result.length_after - (kPieces * kSide + kLean);
  reached("lattice units lost a contact", static_cast<double>(lost) / kPieces);
  EXPECT_GE(lost, 0);
  EXPECT_LE(lost, kPieces * 4 / 3);
}

TEST(ExtremeLayouts, OnePiece) {
  for (const Coord size : {Coord{1}, Coord{1} << 39}) {
    Layout layout{size};
    layout.put(layout.shape_of(test::rectangle(size, size)), {size / 3, 0});  // exactly as wide as the strip
    const motion::compaction::Compaction result = soundly_compacted(layout.marker());
    EXPECT_EQ(result.length_after, size);
    EXPECT_EQ(result.utilisation_after, 1);
  }
  reached("largest, lattice units", 0x1p39);
}

TEST(ExtremeLayouts, PiecesExactlyAsWideAsTheStrip) {
  constexpr Coord kWidth = 987'654'321;
  Layout layout{kWidth};
  const auto bar = layout.shape_of(test::rectangle(1'000, kWidth));
  const auto wedge = layout.shape_of({{0, 0}, {500'000'001, 0}, {1, kWidth}, {0, kWidth}});
  for (Coord k = 0; k < 20; ++k) layout.put(bar, {k * 2'000'000'000, 0});
  for (Coord k = 0; k < 10; ++k) {
    layout.put(wedge, {k * 2'000'000'000 + 100'000'000, 0})
        .put(wedge, {k * 2'000'000'000 + 1'500'000'000, kWidth}, 180);
  }
  const motion::compaction::Compaction result = soundly_compacted(layout.marker());
  const double ratio = static_cast<double>(result.length_after) / static_cast<double>(result.length_before);
  reached("after / before", ratio);
  EXPECT_LE(ratio, 0.1316);

  Marker wider = layout.marker();
  --wider.strip.width;
  const auto refused = make_marker(wider);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kPieceTooWide);
  EXPECT_EQ(refused.error().field, "/pieces/0");
  EXPECT_NE(refused.error().message.find("987654.321"), std::string::npos) << refused.error().message;
}

}  // namespace
}  // namespace selvage::test
