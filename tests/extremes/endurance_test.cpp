// Ten thousand motions one after another on one marker: nothing drifts.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/marker/validity.h"
#include "core/motion/bump.h"
#include "core/motion/drag.h"
#include "core/motion/float_apart.h"
#include "core/motion/tilt.h"
#include "tests/core/motion/markers.h"
#include "tests/extremes/reached.h"
#include "tests/extremes/soundness.h"
#include "tests/support/random.h"

namespace selvage {
namespace {

using test::Random;
using test::reached;

// What motions do to a marker, one at random.  Nothing when it was refused.
class Motions {
 public:
  explicit Motions(Random& random) : random_{random} {}

  [[nodiscard]] std::optional<Marker> next(const Marker& marker) {
    const auto piece = static_cast<std::uint32_t>(random_.below(marker.pieces.size()));
    switch (const Coord kind = random_.between(0, 99)) {
      case 0: return compacted(marker);
      case 1: return floated(marker);
      default: return kind < 70 ? bumped(marker, piece) : dragged(marker, piece, kind);
    }
  }

 private:
  std::optional<Marker> compacted(const Marker& marker) {
    const auto result = compact(marker, compaction_settings(Accuracy::kDraft), sums_);
    return result ? std::optional{result->marker} : std::nullopt;
  }
  std::optional<Marker> floated(const Marker& marker) {
    const auto result = float_apart(marker, float_settings(FloatMode::kLargestMinimum, 5000), sums_);
    return result ? std::optional{result->marker} : std::nullopt;
  }
  std::optional<Marker> bumped(const Marker& marker, std::uint32_t piece) {
    const double angle = random_.part() * 2 * std::numbers::pi;
    const auto result = heal_and_bump(marker, PieceId{piece}, std::cos(angle), std::sin(angle), sums_);
    return result ? std::optional{result->marker} : std::nullopt;
  }
  std::optional<Marker> dragged(const Marker& marker, std::uint32_t piece, Coord kind) {
    const Vec to{random_.between(0, length_of(marker)), random_.between(0, marker.strip.width)};
    return drag(marker, PieceId{piece}, to, kind < 95 ? DragMode::kPlace : DragMode::kPush, sums_).marker;
  }

  Random& random_;
  SumCache sums_;
};

TEST(ExtremeEndurance, TenThousandMotions) {
  constexpr int kMotions = 10'000 / test::kSlowdown;
  Marker start = test::loose_marker(7, 4, 2);
  start.pieces[2].locked = {true, false, false};
  start.pieces[5].locked = {false, true, true};
  Random random{31};
  Motions motions{random};
  Marker now = start;
  int refused = 0;
  for (int k = 0; k < kMotions; ++k) {
    auto next = motions.next(now);
    if (!next) {
      ++refused;
      continue;
    }
    ASSERT_TRUE(is_valid(*next)) << k;
    ASSERT_EQ(next->shapes, start.shapes) << k;
    for (std::size_t i = 0; i < start.pieces.size(); ++i) {
      Piece moved = start.pieces[i];
      if (!moved.locked.x) moved.at.x = next->pieces[i].at.x;
      if (!moved.locked.y) moved.at.y = next->pieces[i].at.y;
      ASSERT_EQ(moved, next->pieces[i]) << k;
    }
    if (k % 500 == 0) test::expect_valid_twice(*next);
    now = std::move(*next);
  }
  test::expect_valid_twice(now);
  reached("motions", kMotions - refused);
  EXPECT_EQ(refused, 0);
}

// Turned to and fro, a piece is still its own shape, rounded once.
TEST(ExtremeEndurance, AHundredTiltsOneAfterAnother) {
  constexpr int kTilts = 100 / test::kSlowdown;
  Marker now = test::loose_marker(9, 3, 2);
  for (Shape& shape : now.shapes) shape.tilt_limit = Angle::of_degrees(3);
  const std::vector<Shape> shapes = now.shapes;
  Random random{37};
  SumCache sums;
  double largest = 0;
  for (int k = 0; k < kTilts; ++k) {
    const TiltMethod method = k % 2 == 0 ? TiltMethod::kLinearisation : TiltMethod::kRelaxation;
    const auto tilted = tilt(now, tilt_settings(method, Accuracy::kDraft), sums);
    ASSERT_TRUE(tilted) << k;
    now = tilted->marker;
    ASSERT_TRUE(is_valid(now)) << k;
    ASSERT_EQ(now.shapes, shapes) << k;
    largest = std::max(largest, tilted->farthest_tilt.degrees);
    // Apart again, for the next to have something to do.
    for (std::uint32_t i = 0; i < now.pieces.size(); ++i) {
      const auto away = heal_and_bump(now, PieceId{i}, random.part() - 0.2, random.part() - 0.5, sums);
      ASSERT_TRUE(away) << k;
      now = away->marker;
    }
    Coord x = 0;
    for (std::uint32_t i = 0; i < now.pieces.size(); ++i) {  // spread out: 6 pieces in 2 rows
      const Box box = box_of(placed_outline(now, PieceId{i}));
      now.pieces[i].at = now.pieces[i].at + Vec{x - box.low.x, i % 2 == 0 ? -box.low.y : now.strip.width - box.high.y};
      x += box.width();
    }
  }
  test::expect_valid_twice(now);
  for (std::uint32_t i = 0; i < now.pieces.size(); ++i) {
    const Piece& piece = now.pieces[i];
    const Polygon fresh = oriented(shapes[piece.shape.value].outline, piece.orientation);
    Polygon placed = placed_outline(now, PieceId{i});
    for (Vec& v : placed) v = v - piece.at;
    EXPECT_EQ(placed, fresh);
    // Area as drafted, but for half a unit along the outline.
    const auto drafted = static_cast<double>(doubled_area(shapes[piece.shape.value].outline));
    EXPECT_NEAR(static_cast<double>(doubled_area(fresh)) / drafted, 1, 1e-4);
  }
  reached("tilts", kTilts);
  reached("farthest, degrees", largest);
}

}  // namespace
}  // namespace selvage
