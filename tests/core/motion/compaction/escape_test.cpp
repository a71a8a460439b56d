// Compaction where linear programs alone find no motion: corners that touch, and lines that extend beyond their edges.
#include "core/motion/compaction/escape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/marker/validity.h"
#include "core/motion/baseline/one_at_a_time.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::compaction {
namespace {

using test::Layout;

Compaction escaped(const Marker& marker, bool sweeps = true) {
  EXPECT_TRUE(is_valid(marker));
  SumCache sums;
  CompactionSettings settings = compaction_settings(Accuracy::kStandard);
  settings.sweeps = sweeps;
  auto done = compact(marker, settings, {sums});
  EXPECT_TRUE(done);
  EXPECT_TRUE(is_valid(done->marker));
  return *std::move(done);
}
Coord swept(const Marker& marker) {
  SumCache sums;
  return baseline::compact_one_at_a_time(marker, {}, {sums})->length_after;
}

// Squares on their corners, each corner on that of its neighbours.
Marker diamonds(int columns, int rows, Coord width) {
  Layout layout{width};
  const auto diamond = layout.shape_of({{50'000, 0}, {100'000, 50'000}, {50'000, 100'000}, {0, 50'000}});
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < rows; ++r) layout.put(diamond, {c * 100'000, r * 100'000});
  }
  return layout.marker();
}

TEST(Escape, DiamondsCornerToCornerInterlock) {
  const Marker roomy = diamonds(4, 2, 260'000);
  EXPECT_LE(escaped(roomy).length_after, 240'010);
  const Marker full = diamonds(8, 4, 400'000);
  EXPECT_LE(escaped(full).length_after, swept(full));
  EXPECT_LT(escaped(full).length_after, 700'000);
}

// The wedge's tip lies on the common corner of two blocks.  It can only advance while the upper block rises, which no
// sweep of single pieces finds.
TEST(Escape, AWedgeEntersWhereTwoCornersMeet) {
  Layout layout{304'000};
  const auto wedge = layout.shape_of({{0, 0}, {100'000, 50'000}, {0, 100'000}});
  const auto block = layout.shape_of(test::rectangle(100'000, 150'000));
  layout.put(block, {0, 0}).put(block, {0, 150'000}).put(wedge, {200'000, 200'000}, 180);
  EXPECT_EQ(swept(layout.marker()), 200'000);
  EXPECT_LE(escaped(layout.marker(), false).length_after, 196'010);
}

// A wheel with square teeth that meets another beyond a tooth's flank: the flank's line passes through free space.
Polygon gear(int teeth, double radius, double depth) {
  Polygon polygon;
  for (int k = 0; k < 4 * teeth; ++k) {
    const double angle = std::numbers::pi * k / (2 * teeth);
    const double r = k / 2 % 2 == 0 ? radius : radius - depth;
    polygon.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
  }
  return polygon;
}

TEST(Escape, NothingHoldsAGearInFreeSpace) {
  // Wherever the second wheel starts, it passes the first and reaches the edge.
  for (int step = 0; step < 24; ++step) {
    Layout layout{1'000'000};
    const auto wheel = layout.shape_of(gear(24, 100'000, 8'000));
    layout.put(wheel, {100'000, 120'000}).put(wheel, {310'000 + 2'000 * step, 330'000 + 7'000 * step});
    const Marker marker = layout.marker();
    EXPECT_LE(escaped(marker).length_after, swept(marker) + 100) << step;
  }
}

TEST(Escape, IsNeverLongerThanSweepsOfFewPieces) {
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    const Marker marker = test::loose_marker(seed);
    ASSERT_LE(marker.pieces.size(), kFewPieces);
    EXPECT_LE(escaped(marker).length_after, swept(marker)) << seed;
  }
}

// Stars and combs, each column with `rows` of them and no two in contact; `shift` makes the gaps unequal.
Marker loose_stars_and_combs(int pieces, int rows, int shift) {
  Layout layout{rows * 300'000};
  const auto star = layout.shape_of(gear(3, 100'000, 60'000));
  const auto comb =
      layout.shape_of({{0, 0}, {150'000, 0}, {150'000, 100'000}, {100'000, 100'000}, {100'000, 30'000}, {0, 30'000}});
  for (int k = 0; k < pieces; ++k) {
    const Vec corner{k / rows * 300'000, k % rows * 300'000};
    const Vec gap{100'000 + k * 7'919 * shift % 40'000, 100'000 + k * 3'571 * shift % 40'000};
    layout.put(k % 3 == 0 ? comb : star, corner + gap);
  }
  return layout.marker();
}

TEST(Escape, IsNotLongerThanSweepsOfHundredsOfLoosePieces) {
  const Marker marker = loose_stars_and_combs(420, 30, 1);
  EXPECT_LE(escaped(marker).length_after, swept(marker));
}

// A second compaction used to shorten all but one of these, by 2 to 27 per cent.  In that of 24 pieces and shift 58, a
// compaction gains nothing, and the one after it does.
TEST(Escape, CompactingLoosePiecesAgainGainsNothing) {
  struct Loose {
    int pieces, rows, shift;
  };
  for (const auto [pieces, rows, shift] :
       {Loose{18, 3, 73}, Loose{15, 4, 69}, Loose{12, 4, 137}, Loose{21, 4, 85}, Loose{24, 5, 24}, Loose{24, 5, 58},
        Loose{42, 10, 3}, Loose{50, 10, 7}, Loose{54, 10, 8}}) {
    const Compaction once = escaped(loose_stars_and_combs(pieces, rows, shift));
    const Coord again = escaped(once.marker).length_after;
    EXPECT_LE(once.length_after - again, once.length_after / 10'000) << pieces << " pieces, shift " << shift;
  }
}

TEST(Escape, RespectsTheLimitOnRounds) {
  SumCache sums;
  CompactionSettings settings = compaction_settings(Accuracy::kStandard);
  settings.rounds = 1;
  const auto done = compact(diamonds(4, 2, 260'000), settings, {sums});
  ASSERT_TRUE(done);
  EXPECT_EQ(done->rounds, 1);
  EXPECT_EQ(done->reason, scene::StopReason::kWorkLimit);
}

TEST(Escape, CanBeCancelled) {
  SumCache sums;
  std::stop_source source;
  scene::Observer observer;
  observer.on_round = [&](const scene::Round&) { source.request_stop(); };
  const auto done =
      compact(diamonds(8, 4, 400'000), compaction_settings(Accuracy::kStandard), {sums, source.get_token(), observer});
  ASSERT_TRUE(done);
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_EQ(done->reason, scene::StopReason::kCancelled);
}

}  // namespace
}  // namespace selvage::motion::compaction
