// Ten thousand motions in succession on one marker, to show that no error accumulates.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/marker/unoccupied.h"
#include "core/marker/validity.h"
#include "core/motion/compaction/open_gap.h"
#include "core/motion/compaction/push.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/floating/float_apart.h"
#include "core/motion/piece/bump.h"
#include "core/motion/piece/relax.h"
#include "core/motion/placing/place.h"
#include "core/motion/separation/separate.h"
#include "core/motion/tilting/tilt.h"
#include "tests/core/motion/markers.h"
#include "tests/extremes/reached.h"
#include "tests/extremes/soundness.h"
#include "tests/support/random.h"

namespace selvage::test {
namespace {

using test::Random;
using test::reached;

// Applies random motions to a marker.  Nothing when a motion rejected it.
class Motions {
 public:
  explicit Motions(Random& random) : random_{random} {}

  [[nodiscard]] std::optional<Marker> next(const Marker& marker) {
    struct Kind {
      int weight;
      std::optional<Marker> (Motions::*run)(const Marker&);
    };
    static constexpr std::array kKinds{Kind{450, &Motions::bumped},   Kind{300, &Motions::dragged},
                                       Kind{100, &Motions::placed},   Kind{60, &Motions::relaxed},
                                       Kind{20, &Motions::separated}, Kind{20, &Motions::pushed},
                                       Kind{10, &Motions::compacted}, Kind{10, &Motions::floated},
                                       Kind{10, &Motions::opened},    Kind{20, &Motions::tilted}};
    static constexpr int kWhole = 1000;
    int drawn = static_cast<int>(random_.below(kWhole));
    for (const Kind& kind : kKinds) {
      if (drawn < kind.weight) return (this->*kind.run)(marker);
      drawn -= kind.weight;
    }
    return std::nullopt;
  }

 private:
  template <class Done>
  static std::optional<Marker> marker_of(Result<Done> done) {
    return done ? std::optional{std::move(done->marker)} : std::nullopt;
  }
  [[nodiscard]] PieceId any_piece(const Marker& marker) {
    return {static_cast<std::uint32_t>(random_.below(marker.pieces.size()))};
  }
  [[nodiscard]] Vec any_place(const Marker& marker) {
    return {random_.between(0, length_of(marker)), random_.between(0, marker.strip.width)};
  }

  std::optional<Marker> bumped(const Marker& marker) {
    const double angle = random_.part() * 2 * std::numbers::pi;
    return marker_of(
        motion::piece::repair_and_bump(marker, any_piece(marker), std::cos(angle), std::sin(angle), {sums_}));
  }
  std::optional<Marker> dragged(const Marker& marker) {
    const motion::dragging::DragMode mode =
        random_.chance(80) ? motion::dragging::DragMode::kPlace : motion::dragging::DragMode::kPush;
    return drag(marker, any_piece(marker), any_place(marker), mode, {sums_}).marker;
  }
  std::optional<Marker> placed(const Marker& marker) {
    return marker_of(
        motion::placing::repair_and_place(marker, any_piece(marker), any_place(marker), {.may_grow = true}, {sums_}));
  }
  std::optional<Marker> relaxed(const Marker& marker) {
    const PieceId piece = any_piece(marker);
    const scene::Scene scene{marker, sums_};
    Marker relaxed = marker;
    relaxed.pieces[piece.value] =
        (random_.chance(50) ? motion::piece::relax(scene, piece) : motion::piece::relax_tilted(scene, piece, 3)).piece;
    return relaxed;
  }
  // Perturbs the marker so that pieces overlap slightly, then separates them.
  std::optional<Marker> separated(const Marker& marker) {
    Marker perturbed = marker;
    const Coord most = marker.strip.width / 500;
    for (Piece& piece : perturbed.pieces) {
      if (!piece.locked.x) piece.at.x += random_.between(-most, most);
      if (!piece.locked.y) piece.at.y += random_.between(-most, most);
    }
    auto done = motion::separation::separate(perturbed, {.grow = 0.05}, {sums_});
    if (!done || !done->apart) return std::nullopt;
    return std::move(done->marker);
  }
  // Pushes with a force on each piece, or by gravity.
  std::optional<Marker> pushed(const Marker& marker) {
    const double x = random_.part() - 0.5;
    std::vector<motion::compaction::Force> forces = motion::compaction::gravity(marker, x, random_.part() - 0.5);
    if (random_.chance(50)) {
      for (motion::compaction::Force& force : forces) force = {force.piece, random_.part() - 0.5, random_.part() - 0.5};
    }
    return marker_of(push(marker, forces, compaction_settings(motion::compaction::Accuracy::kDraft), {sums_}));
  }
  std::optional<Marker> compacted(const Marker& marker) {
    return marker_of(compact(marker, compaction_settings(motion::compaction::Accuracy::kDraft), {sums_}));
  }
  std::optional<Marker> floated(const Marker& marker) {
    return marker_of(float_apart(marker, float_settings(motion::floating::FloatMode::kLargestMinimum, 5000), {sums_}));
  }
  // Enlarges one of the gaps.
  std::optional<Marker> opened(const Marker& marker) {
    const marker::UnoccupiedSettings regions = unoccupied_settings(marker.strip);
    const auto found = unoccupied_regions(marker, regions);
    if (found.empty()) return marker;
    const motion::compaction::GapChoice choice = motion::compaction::AwayFromOutline{random_.below(found.size())};
    return marker_of(
        open_gap(marker, choice, compaction_settings(motion::compaction::Accuracy::kDraft), regions, {sums_}));
  }
  std::optional<Marker> tilted(const Marker& marker) {
    motion::tilting::TiltSettings settings =
        tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kDraft);
    settings.rounds = 1;
    return marker_of(tilt(marker, settings, {sums_}));
  }

  Random& random_;
  SumCache sums_;
};

// Expects that the piece was moved and tilted only as its locks allow, and not changed otherwise.
void expect_kept(const Piece& before, const Piece& after, Angle tilt_limit) {
  Piece kept = after;
  if (!before.locked.x) kept.at.x = before.at.x;
  if (!before.locked.y) kept.at.y = before.at.y;
  if (!before.locked.x && !before.locked.y && !before.locked.tilt) kept.orientation.tilt = before.orientation.tilt;
  ASSERT_EQ(kept, before);
  ASSERT_LE(std::abs(after.orientation.tilt.degrees), tilt_limit.degrees);
}

TEST(ExtremeEndurance, TenThousandMotions) {
  constexpr int kMotions = 10'000 / test::kSlowdown;
  Marker start = test::loose_marker(7, 4, 2);
  start.pieces[2].locked = {true, false, false};
  start.pieces[5].locked = {false, true, true};
  for (Shape& shape : start.shapes) shape.tilt_limit = Angle::of_degrees(0.5);
  Random random{31};
  Motions motions{random};
  Marker now = start;
  int refused = 0;
  int moved = 0;
  std::size_t pairs = 0;
  for (int k = 0; k < kMotions; ++k) {
    SCOPED_TRACE(k);
    auto next = motions.next(now);
    if (!next) {
      ++refused;
      continue;
    }
    ASSERT_EQ(next->shapes, start.shapes);
    for (std::size_t i = 0; i < start.pieces.size(); ++i) {
      ASSERT_NO_FATAL_FAILURE(expect_kept(start.pieces[i], next->pieces[i], start.shapes[0].tilt_limit));
    }
    moved += *next == now ? 0 : 1;
    pairs += test::expect_valid_where_moved(now, *next);
    if (k % 500 == 0) test::expect_valid_twice(*next);
    if (testing::Test::HasFailure()) break;
    now = std::move(*next);
  }
  test::expect_valid_twice(now);
  reached("motions", kMotions - refused);
  reached("of them moved something", moved);
  reached("pairs that CGAL was asked about", static_cast<double>(pairs));
  EXPECT_EQ(refused, 0);
}

// After many tilts to and fro, each piece is still its own shape, rounded only once.
TEST(ExtremeEndurance, AHundredTiltsOneAfterAnother) {
  constexpr int kTilts = 100 / test::kSlowdown;
  Marker now = test::loose_marker(9, 3, 2);
  for (Shape& shape : now.shapes) shape.tilt_limit = Angle::of_degrees(3);
  const std::vector<Shape> shapes = now.shapes;
  Random random{37};
  SumCache sums;
  double largest = 0;
  for (int k = 0; k < kTilts; ++k) {
    const motion::tilting::TiltMethod method =
        k % 2 == 0 ? motion::tilting::TiltMethod::kLinearisation : motion::tilting::TiltMethod::kRelaxation;
    const auto tilted = tilt(now, tilt_settings(method, motion::compaction::Accuracy::kDraft), {sums});
    ASSERT_TRUE(tilted) << k;
    now = tilted->marker;
    ASSERT_TRUE(is_valid(now)) << k;
    ASSERT_EQ(now.shapes, shapes) << k;
    largest = std::max(largest, tilted->farthest_tilt.degrees);
    // Move the pieces apart, so that the next tilt can gain something.
    for (std::uint32_t i = 0; i < now.pieces.size(); ++i) {
      const auto away =
          motion::piece::repair_and_bump(now, PieceId{i}, random.part() - 0.2, random.part() - 0.5, {sums});
      ASSERT_TRUE(away) << k;
      now = away->marker;
    }
    Coord x = 0;
    for (std::uint32_t i = 0; i < now.pieces.size(); ++i) {  // 6 pieces in 2 rows
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
    // The area equals the drafted area, except for half a unit along the outline.
    const auto drafted = static_cast<double>(doubled_area(shapes[piece.shape.value].outline));
    EXPECT_NEAR(static_cast<double>(doubled_area(fresh)) / drafted, 1, 1e-4);
  }
  reached("tilts", kTilts);
  reached("farthest, degrees", largest);
}

}  // namespace
}  // namespace selvage::test
