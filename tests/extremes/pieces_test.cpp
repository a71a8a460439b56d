// Difficult pieces: their star-shaped parts, Minkowski sums, validity proofs and compaction.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/minkowski/sum.h"
#include "core/outline/outline.h"
#include "tests/core/motion/markers.h"
#include "tests/extremes/nasty_pieces.h"
#include "tests/extremes/reached.h"
#include "tests/extremes/soundness.h"
#include "tests/pins/pins.h"
#include "tests/support/exact.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

using test::NastyPiece;
using test::reached;

class ExtremePieces : public testing::TestWithParam<NastyPiece> {};
class ExtremeSums : public testing::TestWithParam<NastyPiece> {};
std::string name_of(const testing::TestParamInfo<NastyPiece>& tested) {
  std::string name = tested.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

TEST_P(ExtremePieces, PartsCoverItExactly) {
  const Polygon& outline = GetParam().outline;
  ASSERT_TRUE(test::is_simple_exactly(outline));
  const auto parts = outline::make_outline(outline)->parts;
  Wide area = 0;
  for (const outline::StarPart& part : parts) area += doubled_area(part.vertices);
  EXPECT_TRUE(area == doubled_area(outline));
  reached(GetParam().name + ": star parts", static_cast<double>(parts.size()));
}

// The sums equal CGAL's up to a unit along the boundary.
TEST_P(ExtremeSums, AreWhatCgalFinds) {
  const Polygon& p = GetParam().outline;
  const Polygon triangle{{0, 0}, {1000, 300}, {200, 900}};
  for (const auto& [other, q] : {std::pair{"itself", p}, {"a triangle", triangle}}) {
    const auto first = outline::make_outline(p);
    const auto second = outline::make_outline(q);
    const test::ExactSum exact{p, q, test::ExactSum::Method::kDecomposition};
    const double apart =
        exact.difference(minkowski::minkowski_sum(first->parts, second->parts)).area / exact.perimeter();
    reached(GetParam().name + ": units off along the boundary of its sum with " + other, apart);
    EXPECT_LE(apart, 1);
  }
}

// Four copies, every second one upside down, with gaps between them.
Marker four_of(const NastyPiece& piece) {
  const Box box = box_of(piece.outline);
  const Vec room{box.width() / 50 + 1, box.height() / 50 + 1};
  const Coord rows = piece.stacked ? 4 : 2;
  const Coord pitch = box.height() + room.y;
  test::Layout layout{std::max<Coord>(rows * pitch, 4)};
  const auto shape = layout.shape_of(piece.outline);
  for (Coord k = 0; k < 4; ++k) {
    const Coord column = piece.stacked ? 0 : k / 2;
    const Vec corner{column * (box.width() + room.x) + room.x * k / 8, k % rows * pitch};
    const bool upside_down = k % 2 == 1;
    layout.put(shape, upside_down ? corner + box.high : corner - box.low, upside_down ? 180 : 0);
  }
  return layout.marker();
}

// The piece, and blocks an eighth of its size to the right of it.
Marker with_blocks(const Polygon& outline) {
  const Box box = box_of(outline);
  test::Layout layout{box.height()};
  layout.put(layout.shape_of(outline), -box.low);
  const auto block = layout.shape_of(test::rectangle(box.width() / 8, box.height() / 8));
  for (Coord k = 0; k < 4; ++k) layout.put(block, {box.width() * 9 / 8, k * box.height() / 4});
  return layout.marker();
}

TEST_P(ExtremePieces, SomeOfThemCompact) {
  const motion::compaction::Compaction result =
      test::soundly_compacted(GetParam().many_parts ? with_blocks(GetParam().outline) : four_of(GetParam()));
  const double ratio = static_cast<double>(result.length_after) / static_cast<double>(result.length_before);
  reached(GetParam().name + ": after / before", ratio);
  reached(GetParam().name + ": rounds", result.rounds);
  expect_pinned("extremes", GetParam().name, ratio);
}

INSTANTIATE_TEST_SUITE_P(Nasty, ExtremePieces, testing::ValuesIn(test::nasty_pieces()), name_of);
INSTANTIATE_TEST_SUITE_P(Nasty, ExtremeSums, testing::ValuesIn(test::pieces_with_judged_sums()), name_of);

TEST(ExtremeOutlines, ASpiralHasThirtyStarParts) {
  EXPECT_GE(outline::make_outline(test::spiral(70, Coord{1} << 28))->parts.size(), 30U);
}

TEST(ExtremeOutlines, TenThousandVerticesAreRefusedHoweverFewAreMeant) {
  std::vector<Vec> corners{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
  std::vector<Vec> repeated;
  for (const Vec corner : corners) repeated.insert(repeated.end(), 2500, corner);
  const auto refused = clean_polygon(repeated);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kTooManyVertices);
  EXPECT_NE(refused.error().message.find("10000"), std::string::npos) << refused.error().message;
  EXPECT_NE(refused.error().message.find("2000"), std::string::npos) << refused.error().message;

  repeated.clear();
  for (const Vec corner : corners) repeated.insert(repeated.end(), geometry::kMaxVertices / 4, corner);
  const auto cleaned = clean_polygon(repeated);
  ASSERT_TRUE(cleaned);
  EXPECT_EQ(cleaned->polygon, corners);
  EXPECT_EQ(cleaned->repairs.duplicate_vertices, geometry::kMaxVertices - 4);
  reached("duplicates left out", static_cast<double>(geometry::kMaxVertices - 4));
}

// Vertices back and forth along one line: spikes of zero width, and vertices one unit off the line.
TEST(ExtremeOutlines, RunsThatAreAllButStraight) {
  std::vector<Vec> straight{{0, 0}};
  for (Coord x = 1; x < 1900; ++x) straight.push_back({x % 3 == 0 ? x - 2 : x + 1, 0});  // moves to and fro
  straight.push_back({3000, 0});
  straight.push_back({3000, 500});
  straight.push_back({1500, 500});
  straight.push_back({1500, 900'000'000});  // a spike of zero width
  straight.push_back({1500, 500});
  straight.push_back({0, 500});
  const auto clean = clean_polygon(straight);
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->polygon, test::rectangle(3000, 500));
  reached("vertices left out", static_cast<double>(clean->repairs.collinear_vertices));
}

}  // namespace
}  // namespace selvage::test
