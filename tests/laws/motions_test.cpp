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
#include "core/motion/floating/float_apart.h"
#include "core/motion/piece/bump.h"
#include "core/motion/separation/separate.h"
#include "tests/laws/random_marker.h"
#include "tests/laws/random_settings.h"

namespace selvage::test {
namespace {

using test::kSlowdown;
using test::Random;
using test::random_settings;

// The law that the motion broke; empty when it broke none.
std::string broken_law(const Marker& before, const Marker& after) {
  if (!is_valid(after)) return "not valid";
  if (length_of(after) > length_of(before)) return "longer";
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

}  // namespace
}  // namespace selvage::test
