// Every motion respects constraints: locks on either axis, rigid groups, buffers and margins.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/compaction/push.h"
#include "core/motion/floating/float_apart.h"
#include "core/motion/piece/bump.h"
#include "core/motion/separation/separate.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::compaction {
namespace {

constexpr Coord kFloatDistance = 40'000;

// The resulting marker of a motion.
Marker moved(const Marker& start, int motion) {
  SumCache sums;
  const auto settings = compaction_settings(Accuracy::kStandard);
  switch (motion) {
    case 0: return compact(start, settings, {sums})->marker;
    case 1: return push(start, gravity(start, -1, 0.5), settings, {sums})->marker;
    case 2: return piece::repair_and_bump(start, PieceId{0}, -1, -0.3, {sums})->marker;
    case 3: return separation::separate(start, {.grow = 0.5}, {sums})->marker;
    default:
      return float_apart(start, float_settings(floating::FloatMode::kLargestMinimum, kFloatDistance), {sums})->marker;
  }
}
constexpr int kMotions = 5;

Marker random_constrained() {
  Marker marker = test::loose_marker(*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::inRange(2, 5), 2);
  const Coord margin = *rc::gen::element<Coord>(0, 15'000);
  marker.strip.margin = margin;
  marker.strip.width += 2 * margin;
  for (Piece& piece : marker.pieces) {
    piece.at = {piece.at.x + margin, piece.at.y + margin};
    piece.locked = {*rc::gen::weightedElement<bool>({{4, false}, {1, true}}),
                    *rc::gen::weightedElement<bool>({{4, false}, {1, true}}), false};
    piece.group = *rc::gen::weightedElement<std::string>({{4, ""}, {1, "a"}, {1, "b"}});
    piece.buffer = *rc::gen::weightedElement<Coord>({{4, 0}, {1, 3'000}});
  }
  return marker;
}

void expect_constraints_hold(const Marker& before, const Marker& after) {
  const model::Ties ties = model::ties_of(before);
  for (std::size_t i = 0; i < before.pieces.size(); ++i) {
    const Vec by = after.pieces[i].at - before.pieces[i].at;
    if (ties.x[i] == model::Ties::kFixed) RC_ASSERT(by.x == 0);
    if (ties.y[i] == model::Ties::kFixed) RC_ASSERT(by.y == 0);
    for (std::size_t j = 0; j < i; ++j) {
      if (before.pieces[i].group.empty() || before.pieces[i].group != before.pieces[j].group) continue;
      RC_ASSERT(by == after.pieces[j].at - before.pieces[j].at);
    }
  }
}

RC_GTEST_PROP(Constraints, HoldToTheLatticeUnitInEveryMotion, ()) {
  const Marker start = random_constrained();
  RC_PRE(is_valid(start));
  const int motion = *rc::gen::inRange(0, kMotions);
  const Marker end = moved(start, motion);
  RC_ASSERT(is_valid(end));
  expect_constraints_hold(start, end);
}

RC_GTEST_PROP(Constraints, HoldWhenOverlapsAreSeparated, ()) {
  Marker start = random_constrained();
  for (Piece& piece : start.pieces) {
    if (piece.locked.x || !piece.group.empty()) continue;
    piece.at.x = std::max<Coord>(0, piece.at.x - *rc::gen::inRange<Coord>(0, 80'000));
  }
  SumCache sums;
  const auto separated = separation::separate(start, {.grow = 1}, {sums});
  RC_PRE(static_cast<bool>(separated));  // refused when a locked piece lies outside
  expect_constraints_hold(start, separated->marker);
  RC_ASSERT(separated->apart == marker::is_valid(separated->marker));
}

Marker three_squares() {
  test::Layout layout{100'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(square, {20'000, 0}).put(square, {40'000, 5'000}).put(square, {60'000, 50'000});
  return layout.marker();
}

// Regression: the relative position of these two is a vertex of their sum, from which no direction leads to it.
TEST(Compact, PiecesMayBeTooCloseCornerToCorner) {
  test::Layout layout{1'500'000};
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  layout.spaced(100).put(square, {0, 0}).put(square, {100'000, 100'000});
  SumCache sums;
  const auto done = compact(layout.marker(), compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
}

TEST(Compact, SlidesAPieceAlongTheAxisItIsFreeOn) {
  Marker marker = three_squares();
  marker.pieces[1].locked = {false, true, true};  // in y: it stops at the first, around which it would otherwise slide
  SumCache sums;
  const auto result = compact(marker, compaction_settings(Accuracy::kStandard), {sums});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->marker.pieces[1].at.y, 5'000);
  EXPECT_LE(result->length_after, 20'000);
  marker.pieces[1].locked = {true, false, true};
  const auto held = compact(marker, compaction_settings(Accuracy::kStandard), {sums});
  ASSERT_TRUE(held);
  EXPECT_EQ(held->marker.pieces[1].at.x, 40'000);
  EXPECT_EQ(held->length_after, 50'000);
}

TEST(Compact, MovesAGroupAsOne) {
  Marker marker = three_squares();
  marker.pieces[0].group = marker.pieces[2].group = "pair";
  SumCache sums;
  const auto result = compact(marker, compaction_settings(Accuracy::kStandard), {sums});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->length_after, 50'000);  // the group's own
  EXPECT_EQ(result->marker.pieces[2].at - result->marker.pieces[0].at, (Vec{40'000, 50'000}));
}

TEST(Bump, MovesAGroupAsOne) {
  Marker marker = three_squares();
  marker.pieces[0].group = marker.pieces[2].group = "pair";
  SumCache sums;
  const auto bumped = piece::repair_and_bump(marker, PieceId{0}, 0, 1, {sums});
  ASSERT_TRUE(bumped);
  EXPECT_EQ(bumped->bump.at, (Vec{20'000, 40'000}));  // the other is at the top
  EXPECT_EQ(bumped->marker.pieces[2].at, (Vec{60'000, 90'000}));
}

TEST(Compact, KeepsBuffersAndMargins) {
  Marker marker = three_squares();
  marker.pieces[0].buffer = 2'000;
  marker.pieces[1].buffer = 1'000;
  marker.strip.margin = 500;
  for (Piece& piece : marker.pieces) piece.at.y += 500;
  for (Piece& piece : marker.pieces) piece.locked = {false, true, true};
  SumCache sums;
  const auto result = compact(marker, compaction_settings(Accuracy::kStandard), {sums});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->marker.pieces[0].at.x, 500);
  EXPECT_EQ(result->marker.pieces[1].at.x, 500 + 10'000 + 3'000);
  EXPECT_TRUE(is_valid(result->marker));
}

}  // namespace
}  // namespace selvage::motion::compaction
