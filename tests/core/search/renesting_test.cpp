#include "core/search/renesting.h"

#include <gtest/gtest.h>

#include "core/marker/figures.h"
#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"

namespace selvage::search {
namespace {

constexpr std::uint64_t kMoves = 1'000;

// Nests for `moves` at most, and for kMoves in vain; returns how many it has made.
std::uint64_t moves_made(const Marker& marker, std::uint64_t moves) {
  SumCache sums;
  Found found{marker, length_of(marker)};
  const Renesting done =
      renest(found, {.moves = moves, .moves_in_vain = kMoves, .least_gain = 1e-5, .seed = 1}, {sums});
  EXPECT_TRUE(is_valid(found.marker));
  EXPECT_LE(found.length, length_of(marker));
  return done.moves;
}

Marker upright(Marker marker) {
  for (Shape& shape : marker.shapes) shape.rotations = {Angle{}};
  return marker;
}

TEST(Renesting, EndsWhenItGainsNothing) {
  // Two squares behind each other, which fit in no other way.
  test::Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(600'000, 600'000));
  layout.put(square, {0, 0}).put(square, {600'000, 0});
  const std::uint64_t made = moves_made(upright(layout.marker()), 10 * kMoves);
  EXPECT_GE(made, kMoves);
  EXPECT_LT(made, kMoves + 10);
}

TEST(Renesting, GoesOnWhenItGains) {
  // Two tall bars, then two low ones: they fill the strip's width only in pairs of one tall and one low bar.
  test::Layout layout{1'000'000};
  const auto tall = layout.shape_of(test::rectangle(300'000, 640'000));
  const auto low = layout.shape_of(test::rectangle(300'000, 340'000));
  layout.put(tall, {0, 0}).put(tall, {300'000, 0}).put(low, {600'000, 0}).put(low, {600'000, 350'000});
  EXPECT_GE(moves_made(upright(layout.marker()), 10 * kMoves), 10 * kMoves);
}

}  // namespace
}  // namespace selvage::search
