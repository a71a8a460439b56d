#include "core/motion/repair/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::repair {
namespace {

using test::Layout;

// Two wedges and two squares on a strip of 10^6 units: overlaps of up to 100 units are repaired.
Marker pair_overlapping_by(Coord depth) {
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(200'000, 200'000));
  layout.put(square, {0, 0}).put(square, {200'000 - depth, 30'000});
  return layout.marker();
}

Result<Repair> healed(const Marker& marker, Marker& out) {
  SumCache sums;
  scene::Scene scene{marker, sums};
  auto repair = repair_overlaps(scene, {sums});
  out = scene.result();
  return repair;
}

TEST(Repair, DoesNothingToAValidMarker) {
  Marker out;
  const Marker start = pair_overlapping_by(0);
  const auto repair = healed(start, out);
  ASSERT_TRUE(repair);
  EXPECT_EQ(repair->pairs, 0U);
  EXPECT_EQ(out, start);
}

TEST(Repair, SeparatesASmallOverlapByItsDepth) {
  for (const Coord depth : {Coord{1}, Coord{7}, Coord{100}}) {
    Marker out;
    const auto repair = healed(pair_overlapping_by(depth), out);
    ASSERT_TRUE(repair) << repair.error().message;
    EXPECT_TRUE(is_valid(out));
    EXPECT_EQ(repair->pairs, 1U);
    EXPECT_NEAR(repair->deepest, static_cast<double>(depth), 1e-6);
    EXPECT_LE(repair->farthest_move, depth);
    EXPECT_EQ(repair->lengthened, depth);  // the left edge holds one square, so only the right one can move
  }
}

TEST(Repair, RefusesDeepOverlapsAndNamesThem) {
  Marker out;
  const Marker start = pair_overlapping_by(101);
  const auto repair = healed(start, out);
  ASSERT_FALSE(repair);
  EXPECT_EQ(repair.error().code, ErrorCode::kMarkerOverlaps);
  EXPECT_NE(repair.error().message.find("\"p0\" and \"p1\" by 0.101 mm"), std::string::npos) << repair.error().message;
  EXPECT_EQ(out, start);
}

// Of 1,500 pieces at one position, 1,124,250 pairs overlap; a piece no larger than the limit overlaps none deeply.
TEST(Repair, RefusesHeaps) {
  for (const Coord side : {200'000, 100}) {
    Layout layout{1'000'000};
    const auto square = layout.shape_of(test::rectangle(side, side));
    for (int k = 0; k < 1'500; ++k) layout.put(square, {0, 0});
    Marker out;
    const auto repair = healed(layout.marker(), out);
    ASSERT_FALSE(repair);
    EXPECT_EQ(repair.error().code, ErrorCode::kMarkerOverlaps);
    EXPECT_TRUE(repair.error().message.starts_with("at least 1000000 pairs of pieces overlap"))
        << repair.error().message;
  }
}

TEST(Repair, ReturnsPiecesThatLeaveTheStripSlightly) {
  Marker start = pair_overlapping_by(0);
  start.pieces[0].at = {-5, -50};
  Marker out;
  const auto repair = healed(start, out);
  ASSERT_TRUE(repair) << repair.error().message;
  EXPECT_TRUE(is_valid(out));
  EXPECT_EQ(repair->protruding, 1U);
  start.pieces[0].at = {-101, 0};
  const auto refused = healed(start, out);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kOutsideStrip);
  EXPECT_EQ(refused.error().field, "/pieces/0/at");
}

TEST(Repair, ReportsWhenThereIsNoRoom) {
  Marker start = pair_overlapping_by(50);
  for (Piece& piece : start.pieces) piece.locked = true;
  Marker out;
  const auto repair = healed(start, out);
  ASSERT_FALSE(repair);
  EXPECT_EQ(repair.error().code, ErrorCode::kRepairFailed);
  EXPECT_EQ(out, start);
}

TEST(Repair, ReportsWhenItWasCancelled) {
  std::stop_source source;
  source.request_stop();
  SumCache sums;
  const Marker start = pair_overlapping_by(50);
  scene::Scene scene{start, sums};
  const auto repair = repair_overlaps(scene, {sums, source.get_token()});
  ASSERT_FALSE(repair);
  EXPECT_EQ(repair.error().code, ErrorCode::kStoppedEarly);
  EXPECT_EQ(scene.result(), start);
}

TEST(Repair, SeparatesPiecesCloserThanTheSpacing) {
  Marker start = pair_overlapping_by(-950);
  start.spacing = 1000;
  Marker out;
  const auto repair = healed(start, out);
  ASSERT_TRUE(repair) << repair.error().message;
  EXPECT_TRUE(is_valid(out));
  EXPECT_NEAR(repair->deepest, 50, 1e-6);
}

// The columns of the largest program that is solved to repair the marker.
int most_columns(const Marker& marker, Marker& out) {
  int most = 0;
  scene::Observer observer;
  observer.on_program = [&](const lp::LinearProgram& program) { most = std::max(most, program.columns()); };
  SumCache sums;
  scene::Scene scene{marker, sums};
  EXPECT_TRUE(repair_overlaps(scene, {sums, {}, observer}));
  out = scene.result();
  EXPECT_TRUE(is_valid(out));
  return most;
}

TEST(Repair, ModelsOnlyPiecesThatOverlap) {
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(90'000, 90'000));
  for (Coord i = 0; i < 100; ++i) layout.put(square, {i / 10 * 100'000, i % 10 * 100'000});
  Marker marker = layout.marker();
  marker.pieces[54].at.y += 10'050;  // into the next by 50
  Marker out;
  EXPECT_EQ(most_columns(marker, out), 9);  // of two pieces, their targets and distances; and the length
  EXPECT_EQ(out.pieces[53], marker.pieces[53]);
}

TEST(Repair,
     ModelsPiecesThatArePushedInTurn) {  // nine in a stack, of which the lowest two overlap: all but the lowest go up
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  layout.put(square, {0, 0}, 0, true);
  for (Coord i = 1; i < 9; ++i) layout.put(square, {0, i * 100'000 - 50});
  for (Coord i = 0; i < 9; ++i) layout.put(square, {300'000, i * 100'000});
  Marker out;
  EXPECT_EQ(most_columns(layout.marker(), out), 8 * 4 + 1);
  for (std::size_t i = 1; i < 9; ++i) {
    EXPECT_EQ(out.pieces[i].at, (Vec{0, static_cast<Coord>(i) * 100'000}));
    EXPECT_EQ(out.pieces[i + 9], layout.marker().pieces[i + 9]);
  }
}

// A point that lies in a notch, both as wide as the strip together: neither piece has room for a row's margin.
TEST(Repair, LeavesAStackAloneThatFillsTheStripExactly) {
  Layout layout{1'000'000};
  const auto notch = layout.shape_of({{0, 0}, {400'000, 0}, {400'000, 600'000}, {200'000, 400'000}, {0, 600'000}});
  const auto point =
      layout.shape_of({{200'000, 0}, {400'000, 200'000}, {400'000, 600'000}, {0, 600'000}, {0, 200'000}});
  const auto square = layout.shape_of(test::rectangle(200'000, 200'000));
  layout.put(notch, {0, 0}).put(point, {0, 400'000}).put(square, {400'000 - 50, 300'000});
  Marker out;
  const auto repair = healed(layout.marker(), out);
  ASSERT_TRUE(repair) << repair.error().message;
  EXPECT_TRUE(is_valid(out));
  EXPECT_EQ(out.pieces[0], layout.marker().pieces[0]);
  EXPECT_EQ(out.pieces[1], layout.marker().pieces[1]);
  EXPECT_EQ(out.pieces[2].at, (Vec{400'000, 300'000}));
}

TEST(Repair, PerturbedCompactedMarkersAreRepairedAtTheSameLength) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SumCache sums;
    const auto tight = compact(test::loose_marker(seed), compaction_settings(compaction::Accuracy::kStandard), {sums});
    ASSERT_TRUE(tight);
    Marker perturbed = tight->marker;
    std::mt19937 random{seed};
    for (Piece& piece : perturbed.pieces) {
      piece.at.x += static_cast<Coord>(random() % 21) - 10;
      piece.at.y += static_cast<Coord>(random() % 21) - 10;
    }
    const auto again = compact(perturbed, compaction_settings(compaction::Accuracy::kStandard), {sums});
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_TRUE(is_valid(again->marker));
    EXPECT_GT(again->repair.pairs + again->repair.protruding, 0U);
    EXPECT_LE(static_cast<double>(again->length_after), 1.001 * static_cast<double>(tight->length_after));
  }
}

}  // namespace
}  // namespace selvage::motion::repair
