// Tests of nesting where the cloth ends before all pieces lie on it.
#include "core/nesting/cloth_end.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "tests/core/nesting/nested.h"
#include "tests/core/nesting/unplaced_pieces.h"

namespace selvage::nesting {
namespace {

using test::kWidth;
using test::nested;
using test::rectangle;
using test::settings_of;
using test::unplaced_pieces;

TEST(ClothEnd, PutsPiecesBackOnlyWhileThereIsTime) {
  // The large pieces leave room for the small ones above them, which come after them in columns.
  Marker marker = unplaced_pieces({rectangle(500'000, 800'000), rectangle(400'000, 150'000)}, 8, kWidth);
  for (Shape& shape : marker.shapes) shape.rotations = {{0}};
  marker.strip.longest = kWidth;
  NestSettings settings = settings_of(0);
  const Nesting with_time = nested(marker, settings);
  EXPECT_TRUE(is_valid(with_time.marker));
  settings.elapsed = [] { return 1.0; };
  const Nesting without = nested(marker, settings);
  EXPECT_TRUE(is_valid(without.marker));
  EXPECT_LT(without.marker.pieces.size(), with_time.marker.pieces.size());
}

TEST(ClothEnd, APieceThatFitsNoClothOfThisLengthUsesNoMoves) {
  Marker marker = unplaced_pieces({rectangle(900'000, 400'000), rectangle(1'100'000, 100'000)}, 3, kWidth);
  for (Shape& shape : marker.shapes) shape.rotations = {{0}};
  marker.strip.longest = kWidth;
  const NestSettings settings = settings_of(2'000);
  const Nesting nesting = nested(marker, settings);
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_EQ(nesting.left_over, 1u);
  EXPECT_EQ(nesting.marker.unplaced[0].id, "1");
  EXPECT_LE(static_cast<double>(nesting.moves),
            settings.tuning.end_patience * static_cast<double>(settings.moves) + 100);
}

}  // namespace
}  // namespace selvage::nesting
