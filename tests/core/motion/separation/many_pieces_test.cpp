// Separation of markers with more pieces than SeparationTuning::many.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/separation/separate.h"
#include "tests/support/garment.h"
#include "tests/support/random.h"
#include "tests/support/tiled/tiled_marker.h"

namespace selvage::motion::separation {
namespace {

// Every piece displaced by up to 2 % of the width on each axis.
Marker noisy(Marker marker) {
  test::Random random{7};
  const Coord most = marker.strip.width / 50;
  for (Piece& piece : marker.pieces) piece.at = piece.at + random.point(-most, most);
  return marker;
}

TEST(Separate, OfManyPiecesMovesOnlyThoseThatOverlapAfterTheFirstRound) {
  const Marker marker = noisy(test::tiled(test::garment("jeans_06g"), 240));
  SeparationSettings settings{.grow = 5};
  settings.tuning.many = 200;
  ASSERT_GT(marker.pieces.size(), settings.tuning.many);
  SumCache sums;
  scene::Observer observer;
  std::vector<std::pair<int, int>> programs;  // the round before, and columns
  int rounds = 0;
  observer.on_round = [&](const scene::Round& round) { rounds = round.number; };
  observer.on_program = [&](const lp::LinearProgram& program) { programs.emplace_back(rounds, program.columns()); };
  const auto result = separate(marker, settings, {sums, {}, observer});
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->apart);
  EXPECT_TRUE(is_valid(result->marker));
  ASSERT_GT(rounds, 1);
  int first = 0;
  int later = 0;
  for (const auto& [round, columns] : programs) {
    if (round == 0) {
      ++first;
    } else if (columns >= programs.front().second) {
      ++later;
    }
  }
  EXPECT_EQ(first, 1);  // of all pieces at once, since most of them overlap
  EXPECT_EQ(later, 0);
}

}  // namespace
}  // namespace selvage::motion::separation
