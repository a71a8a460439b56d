#include "core/packing/contain.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"
#include "tests/core/packing/polyominoes.h"

namespace selvage::packing {
namespace {

std::vector<PieceId> all_of(const Marker& marker) {
  std::vector<PieceId> pieces;
  for (std::uint32_t k = 0; k < marker.pieces.size(); ++k) pieces.push_back({k});
  return pieces;
}

Containment contained(const Marker& marker, const std::vector<PieceId>& pieces, const Box& room,
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
  const Containment result = contained(layout.marker(), halves, {{0, 0}, {30'000, 30'000}});
  ASSERT_EQ(result.verdict, Verdict::kFound);
  EXPECT_TRUE(is_valid(result.marker));
  EXPECT_EQ(result.length_after, 30'000);
}

TEST(Contain, ProvesThatPiecesAreTooLarge) {
  test::Layout layout = with_slot();
  layout.put(layout.shape_of(test::rectangle(10'000, 10'010)), {50'000, 0});
  EXPECT_EQ(contained(layout.marker(), {{1}}, {{0, 0}, {30'000, 30'000}}).verdict, Verdict::kImpossible);
  layout = with_slot();
  layout.put(layout.shape_of(test::rectangle(20'010, 10'000)), {50'000, 0});
  EXPECT_EQ(contained(layout.marker(), {{1}}, {{0, 0}, {30'000, 30'000}}).verdict, Verdict::kImpossible);
}

TEST(Contain, IsUndecidedAtTheWorkLimit) {
  test::Layout layout{31'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  for (int k = 0; k < 10; ++k) layout.put(square, {0, 0});
  ContainSettings settings;
  settings.limits.nodes = 2;
  const Containment result = contained(layout.marker(), all_of(layout.marker()), {{0, 0}, {31'000, 31'000}}, settings);
  EXPECT_EQ(result.verdict, Verdict::kUndecided);
  EXPECT_EQ(result.reason, scene::StopReason::kWorkLimit);
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
