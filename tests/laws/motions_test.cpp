// Laws that hold for every motion, tested on random markers: the result is valid, is not worse, and locked pieces have
// not moved.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/compaction/open_gap.h"
#include "core/motion/compaction/push.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/floating/float_apart.h"
#include "core/motion/piece/bump.h"
#include "core/motion/piece/relax.h"
#include "core/motion/placing/place.h"
#include "core/motion/separation/separate.h"
#include "core/motion/tilting/tilt.h"
#include "core/search/refine.h"
#include "tests/laws/random_marker.h"
#include "tests/motions/arguments.h"

namespace selvage::test {
namespace {

using test::kSlowdown;
using test::Random;
using test::random_settings;

// The law that the motion violated; empty when it violated none.
std::string broken_law(const Marker& before, const Marker& after, bool may_lengthen = false) {
  if (!is_valid(after)) return "not valid";
  if (!may_lengthen && length_of(after) > length_of(before)) return "longer";
  if (after.shapes != before.shapes || after.strip != before.strip || after.spacing != before.spacing ||
      after.pieces.size() != before.pieces.size()) {
    return "a different marker";
  }
  for (std::size_t k = 0; k < before.pieces.size(); ++k) {
    Piece moved = before.pieces[k];
    if (!moved.locked) moved.at = after.pieces[k].at;
    if (moved != after.pieces[k]) return "piece " + std::to_string(k) + " was changed";
  }
  return "";
}

TEST(MotionLaws, Compaction) {
  Random random{101};
  for (int trial = 0; trial < 2500 / kSlowdown; ++trial) {
    const Marker marker = test::random_marker(random);
    SumCache sums;
    const auto settings = random_settings(random);
    const auto result = compact(marker, settings, {sums});
    ASSERT_TRUE(result) << trial << ' ' << result.error().message;
    ASSERT_EQ(broken_law(marker, result->marker), "") << trial;
    ASSERT_EQ(result->repair.pairs, 0U) << trial;
    ASSERT_EQ(result->length_after, length_of(result->marker)) << trial;
    ASSERT_GE(result->utilisation_after, result->utilisation_before) << trial;
  }
}

TEST(MotionLaws, Pushing) {
  Random random{102};
  for (int trial = 0; trial < 1500 / kSlowdown; ++trial) {
    const Marker marker = test::random_marker(random);
    std::vector<motion::compaction::Force> forces;
    double largest = 0;
    for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
      if (random.chance(50)) continue;
      forces.push_back({PieceId{i}, 2 * random.part() - 1, 2 * random.part() - 1});
      largest = std::max({largest, std::abs(forces.back().x), std::abs(forces.back().y)});
    }
    SumCache sums;
    const auto result = push(marker, forces, random_settings(random), {sums});
    ASSERT_TRUE(result) << trial << ' ' << result.error().message;
    ASSERT_EQ(broken_law(marker, result->marker), "") << trial;
    ASSERT_GE(result->gain, 0) << trial;
    double gain = 0;
    for (const motion::compaction::Force& force : forces) {
      const Vec by = result->marker.pieces[force.piece.value].at - marker.pieces[force.piece.value].at;
      gain += (force.x * static_cast<double>(by.x) + force.y * static_cast<double>(by.y)) / largest;
    }
    ASSERT_NEAR(result->gain, gain, 1e-9 * static_cast<double>(marker.strip.width)) << trial;
  }
}

TEST(MotionLaws, Bumping) {
  Random random{103};
  for (int trial = 0; trial < 4000 / kSlowdown; ++trial) {
    const Marker marker = test::random_marker(random);
    const auto piece = static_cast<std::uint32_t>(random.below(marker.pieces.size()));
    const double angle = 2 * std::numbers::pi * random.part();
    SumCache sums;
    const scene::Scene scene{marker, sums};
    const motion::piece::Bump result = motion::piece::bump(scene, PieceId{piece}, std::cos(angle), std::sin(angle));
    Marker moved = marker;
    moved.pieces[piece].at = result.at;
    ASSERT_EQ(broken_law(marker, moved), "") << trial;
    const Vec by = result.at - marker.pieces[piece].at;
    ASSERT_GE(result.gain, 0) << trial;
    ASSERT_NEAR(result.gain, std::cos(angle) * static_cast<double>(by.x) + std::sin(angle) * static_cast<double>(by.y),
                1e-9 * static_cast<double>(marker.strip.width))
        << trial;
  }
}

TEST(MotionLaws, Separation) {
  Random random{104};
  int apart = 0;
  const int trials = 1500 / kSlowdown;
  for (int trial = 0; trial < trials; ++trial) {
    const Marker marker = test::perturbed(random, test::random_marker(random), 0.1 * random.part());
    motion::separation::SeparationSettings settings;
    settings.grow = random.chance(50) ? 0.05 : 0;
    settings.target = random.chance(20) ? motion::repair::TargetRule::kKernelRay : motion::repair::TargetRule::kNearest;
    SumCache sums;
    const auto result = separate(marker, settings, {sums});
    ASSERT_TRUE(result) << trial << ' ' << result.error().message;
    ASSERT_EQ(result->apart, is_valid(result->marker)) << trial;
    ASSERT_EQ(result->apart, result->remaining.empty()) << trial;
    ASSERT_LE(static_cast<double>(result->length_after),
              (1 + settings.grow) * static_cast<double>(result->length_before))
        << trial;
    double moved = 0;
    for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
      const Vec by = result->marker.pieces[k].at - marker.pieces[k].at;
      ASSERT_TRUE(!marker.pieces[k].locked || by == Vec{}) << trial;
      moved += static_cast<double>(std::abs(by.x) + std::abs(by.y));
    }
    ASSERT_NEAR(result->moved, moved, 1e-9 * moved) << trial;
    apart += result->apart ? 1 : 0;
  }
  EXPECT_GT(apart, trials / 2);
}

TEST(MotionLaws, Floating) {
  Random random{105};
  for (int trial = 0; trial < 1000 / kSlowdown; ++trial) {
    const Marker marker = test::random_marker(random);
    constexpr std::array kModes{motion::floating::FloatMode::kLargestMinimum,
                                motion::floating::FloatMode::kGivenDistance, motion::floating::FloatMode::kLargestTotal,
                                motion::floating::FloatMode::kUniform, motion::floating::FloatMode::kTwoStep};
    const auto settings =
        float_settings(kModes[random.below(kModes.size())], marker.strip.width / random.between(5, 200) + 1);
    SumCache sums;
    const auto result = float_apart(marker, settings, {sums});
    ASSERT_TRUE(result) << trial << ' ' << result.error().message;
    ASSERT_EQ(broken_law(marker, result->marker), "") << trial;
    ASSERT_GE(result->least_after, result->least_before) << trial;
  }
}

TEST(MotionLaws, OpeningAGap) {
  Random random{106};
  int larger = 0;
  const int trials = 500 / kSlowdown;
  for (int trial = 0; trial < trials; ++trial) {
    const Marker marker = test::random_marker(random);
    const marker::UnoccupiedSettings regions{1e-3, marker.strip.width / random.between(50, 2000)};
    const auto found = unoccupied_regions(marker, regions);
    if (found.empty()) continue;
    const std::size_t k = random.below(found.size());
    const motion::compaction::GapChoice choice =
        random.chance(50)
            ? motion::compaction::GapChoice{motion::compaction::AwayFromOutline{k}}
            : motion::compaction::GapChoice{motion::compaction::AwayFromPoint{point_inside(found[k].region)}};
    SumCache sums;
    const auto result = open_gap(marker, choice, random_settings(random), regions, {sums});
    ASSERT_TRUE(result) << trial << ' ' << result.error().message;
    ASSERT_EQ(broken_law(marker, result->marker), "") << trial;
    ASSERT_EQ(result->before.area, found[k].area) << trial;
    ASSERT_GE(result->after.area, result->before.area) << trial;
    ASSERT_TRUE(result->rounds > 0 || result->marker == marker) << trial;
    larger += result->after.area > result->before.area ? 1 : 0;
  }
  EXPECT_GT(larger, trials / 4);
}

// Empty when no piece except this one has changed.
std::string others_moved(const Marker& before, const Marker& after, PieceId piece) {
  for (std::size_t k = 0; k < before.pieces.size(); ++k) {
    if (k != piece.value && after.pieces[k] != before.pieces[k]) return "piece " + std::to_string(k) + " moved";
  }
  return "";
}

TEST(MotionLaws, Dragging) {
  Random random{107};
  int moved = 0;
  const int trials = 1000 / kSlowdown;
  for (int trial = 0; trial < trials; ++trial) {
    const Marker marker = test::random_marker(random);
    const PieceId piece = any_piece(random, marker);
    const bool push = random.chance(50);
    const auto mode = push ? motion::dragging::DragMode::kPush : motion::dragging::DragMode::kPlace;
    SumCache sums;
    const auto result = drag(marker, piece, any_place(random, marker), mode, {sums});
    ASSERT_EQ(broken_law(marker, result.marker, true), "") << trial;
    if (!push) {
      ASSERT_EQ(others_moved(marker, result.marker, piece), "") << trial;
    }
    moved += result.marker == marker ? 0 : 1;
  }
  EXPECT_GT(moved, trials / 4);
}

TEST(MotionLaws, Placing) {
  Random random{108};
  for (int trial = 0; trial < 1000 / kSlowdown; ++trial) {
    const Marker marker = test::random_marker(random);
    const PieceId piece = any_piece(random, marker);
    const Vec wanted = any_place(random, marker);
    SumCache sums;
    const auto result = motion::placing::repair_and_place(marker, piece, wanted, {}, {sums});
    ASSERT_TRUE(result) << trial << ' ' << result.error().message;
    ASSERT_EQ(broken_law(marker, result->marker), "") << trial;
    ASSERT_EQ(others_moved(marker, result->marker, piece), "") << trial;
  }
}

TEST(MotionLaws, Relaxing) {
  Random random{109};
  for (int trial = 0; trial < 1000 / kSlowdown; ++trial) {
    const Marker marker = test::random_marker(random);
    const PieceId piece = any_piece(random, marker);
    SumCache sums;
    const auto result = motion::piece::repair_and_relax(marker, piece, 0, {sums});
    ASSERT_TRUE(result) << trial << ' ' << result.error().message;
    ASSERT_EQ(broken_law(marker, result->marker), "") << trial;
    ASSERT_EQ(others_moved(marker, result->marker, piece), "") << trial;
    ASSERT_GE(result->relaxation.freedom, 0) << trial;
  }
}

// What tilting may change: positions, and tilts within the limit.
std::string broken_tilt_law(const Marker& before, const Marker& after, Angle limit) {
  if (!is_valid(after)) return "not valid";
  if (length_of(after) > length_of(before)) return "longer";
  if (after.pieces.size() != before.pieces.size()) return "another marker";
  for (std::size_t k = 0; k < before.pieces.size(); ++k) {
    const Piece& was = before.pieces[k];
    const Piece& is = after.pieces[k];
    if (was.locked && is != was) return "locked piece " + std::to_string(k) + " moved";
    if (is.orientation.rotation != was.orientation.rotation || is.orientation.flip != was.orientation.flip) {
      return "piece " + std::to_string(k) + " was rotated or flipped";
    }
    if (std::abs(is.orientation.tilt.degrees) > limit.degrees + 1e-12) {
      return "piece " + std::to_string(k) + " is tilted beyond the limit";
    }
  }
  return "";
}

TEST(MotionLaws, Tilting) {
  Random random{110};
  for (int trial = 0; trial < 60 / kSlowdown; ++trial) {
    const Marker marker = test::random_marker(random);
    const auto method =
        random.chance(50) ? motion::tilting::TiltMethod::kLinearisation : motion::tilting::TiltMethod::kRelaxation;
    motion::tilting::TiltSettings settings = tilt_settings(method, motion::compaction::Accuracy::kDraft);
    settings.limit = Angle::of_degrees(3 * random.part());
    settings.rounds = 2;
    SumCache sums;
    const auto result = tilt(marker, settings, {sums});
    ASSERT_TRUE(result) << trial << ' ' << result.error().message;
    ASSERT_EQ(broken_tilt_law(marker, result->marker, *settings.limit), "") << trial;
    ASSERT_LE(result->length_after, result->length_compacted) << trial;
  }
}

TEST(MotionLaws, Refinement) {
  Random random{111};
  for (int trial = 0; trial < 60 / kSlowdown; ++trial) {
    const Marker marker = test::random_marker(random);
    SumCache sums;
    const auto compaction = compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
    ASSERT_TRUE(compaction) << trial << ' ' << compaction.error().message;
    const auto seed = static_cast<std::uint32_t>(random.below(1000));
    const auto result = search::refine(marker, {.variants = 2, .effort = 30, .tilts = false, .seed = seed}, {sums});
    ASSERT_TRUE(result) << trial << ' ' << result.error().message;
    ASSERT_TRUE(is_valid(result->marker)) << trial;
    ASSERT_LE(result->length_after, compaction->length_after) << trial;
    for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
      ASSERT_TRUE(!marker.pieces[k].locked || result->marker.pieces[k] == marker.pieces[k]) << trial;
    }
  }
}

// `fine` may use every cheaper preset and tilting, and is never longer than any of them on the same marker.
TEST(MotionLaws, RefinementIsNotLongerThanThePresetsThatItMayUse) {
  using motion::compaction::Accuracy;
  Random random{112};
  for (int trial = 0; trial < 40 / kSlowdown; ++trial) {
    Marker marker = test::random_marker(random);
    for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(random.chance(70) ? 2 : 0);
    SumCache sums;
    const auto tilting =
        tilt(marker, tilt_settings(motion::tilting::TiltMethod::kLinearisation, Accuracy::kStandard), {sums});
    const auto result = search::refine(marker, {.variants = 2, .effort = 30, .tilts = true}, {sums});
    ASSERT_TRUE(result && tilting) << trial;
    ASSERT_LE(result->length_after, tilting->length_after) << trial;
    for (const Accuracy accuracy : {Accuracy::kDraft, Accuracy::kStandard}) {
      const auto compaction = compact(marker, compaction_settings(accuracy), {sums});
      ASSERT_TRUE(compaction) << trial;
      ASSERT_LE(result->length_after, compaction->length_after) << trial;
    }
  }
}

}  // namespace
}  // namespace selvage::test
