// Markers of more pieces than are searched at once.
#include "core/nesting/batches/batches.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/marker/figures.h"
#include "core/marker/validity.h"
#include "protocol/execution/thread_pool.h"
#include "tests/core/nesting/nested.h"
#include "tests/core/nesting/unplaced_pieces.h"

namespace selvage::nesting {
namespace {

using test::ids_of;
using test::kWidth;
using test::nested;
using test::rectangle;
using test::settings_of;
using test::unplaced_pieces;

// Triangles that interlock when rotated by 180 degrees, more than are searched at once.
Marker many_triangles(std::size_t pieces) {
  return unplaced_pieces({{{0, 0}, {80'000, 0}, {0, 60'000}}, rectangle(30'000, 20'000)}, pieces, kWidth);
}
NestSettings in_batches(std::uint64_t moves) {
  NestSettings settings = settings_of(moves);
  settings.tuning.most_pieces = 60;
  settings.tuning.batches = {.pieces = 40, .beside = 20};
  return settings;
}

TEST(NestInBatches, IsValidAndShorterThanOnShelves) {
  Marker marker = many_triangles(120);
  marker.pieces.push_back(marker.unplaced.back());
  marker.unplaced.pop_back();
  marker.pieces.back().at = {0, 500'000};
  marker.pieces.back().locked = true;
  const Nesting shelves = nested(marker, in_batches(0));
  const Nesting nesting = nested(marker, in_batches(2'000));
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_EQ(ids_of(nesting.marker), ids_of(marker));
  EXPECT_EQ(nesting.marker.pieces.front(), marker.pieces.front());
  EXPECT_LT(nesting.length_after, shelves.length_after);
  EXPECT_GT(marker::utilisation_at(nesting.marker, nesting.length_after), 0.7);
}

TEST(NestInBatches, IsTheSameOnAnyNumberOfThreads) {
  const Marker marker = many_triangles(100);
  const Nesting expected = nested(marker, in_batches(600));
  const Nesting found = nested(marker, in_batches(600), protocol::execution::ThreadPool{2});
  EXPECT_EQ(found.marker, expected.marker);
  EXPECT_EQ(found.moves, expected.moves);
}

TEST(NestInBatches, SolvesNoProgramThatIsLargerThanABatch) {
  const Marker marker = many_triangles(150);
  int columns = 0;
  scene::Observer observer;
  observer.on_program = [&](const lp::LinearProgram& program) { columns = std::max(columns, program.columns()); };
  SumCache sums;
  const auto nesting = nest(marker, in_batches(900), {sums, {}, observer});
  ASSERT_TRUE(nesting);
  EXPECT_GT(columns, 0);
  EXPECT_LE(columns, 4 * (40 + 20) + 8);
}

// When the time is up, the running program is the last one, and few moves follow.
TEST(NestInBatches, EndsWithTheProgramThatRunsAtTheTimeLimit) {
  for (const std::size_t pieces : {30U, 200U}) {
    for (const int last : {1, 3, 10}) {
      int programs = 0;
      scene::Observer observer;
      observer.on_program = [&](const lp::LinearProgram&) { ++programs; };
      NestSettings settings = in_batches(100'000);
      settings.elapsed = [&] { return programs >= last ? 1.0 : 0.1; };
      SumCache sums;
      const auto nesting = nest(many_triangles(pieces), settings, {sums, {}, observer});
      ASSERT_TRUE(nesting);
      EXPECT_EQ(programs, last) << pieces << " pieces";
      EXPECT_TRUE(is_valid(nesting->marker));
      EXPECT_EQ(nesting->marker.pieces.size(), pieces);
    }
  }
}

TEST(NestInBatches, OfFewerPiecesThanUsualIsValid) {
  const Marker marker = unplaced_pieces({rectangle(30'000, 20'000)}, 300, kWidth);
  NestSettings settings = settings_of(1'000);
  settings.tuning.most_pieces = 200;
  const Nesting nesting = nested(marker, settings);
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_EQ(nesting.marker.pieces.size(), 300u);
}

}  // namespace
}  // namespace selvage::nesting
