// Tests of core/nesting/depth: depths against the exact predicates, and the grid against the depths.
#include "core/nesting/depth/depth_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/geometry/distance.h"
#include "core/geometry/overlap.h"
#include "core/nesting/depth/depth_maps.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/layout/piece_set.h"
#include "tests/core/nesting/unplaced_pieces.h"

namespace selvage::nesting::depth {
namespace {

using layout::PieceSet;
using test::kWidth;
using test::Random;

constexpr MapScale kScale{.pixel = 4, .charge = 5};

struct Pair {
  SumCache sums;
  PieceSet set;
  DepthMaps maps;

  explicit Pair(const Marker& marker)
      : set{*piece_set_of(marker, layout::PlacedPiecesMay::kMove, sums)}, maps{set, kScale, 1 << 20} {}
  [[nodiscard]] const layout::Turned& turned(std::size_t piece, std::size_t turn) const {
    return set.kind(piece).turned[turn];
  }
};

// Two random shapes, which may have all eight exact orientations.
Marker two_shapes(Random& random) {
  Marker marker = test::unplaced_pieces(
      {test::random_polygon(random, test::kSide), test::random_polygon(random, 2 * test::kSide)}, 2, kWidth);
  for (Shape& shape : marker.shapes) shape.may_flip = true;
  return marker;
}

Polygon oriented_outline(const Marker& marker, std::size_t shape, const layout::Turned& turned) {
  return oriented(marker.shapes[shape].outline, turned.orientation);
}

TEST(DepthMaps, AreNotMadeOnceStopped) {
  Random random{9};
  const Pair pair{two_shapes(random)};
  bool stopped = true;
  DepthMaps maps{pair.set, kScale, 1 << 20, [&] { return stopped; }};
  const auto& p = pair.turned(0, 0);
  const auto& q = pair.turned(1, 0);
  const DepthMap* const missing = maps.view(p, q).map;
  EXPECT_EQ(maps.view(q, p).map, missing);
  stopped = false;
  EXPECT_NE(maps.view(p, q).map, missing);
  EXPECT_EQ(maps.view(p, q).map, maps.view(q, p).map);
}

TEST(DepthMap, IsZeroExactlyWhenPiecesAreApart) {
  Random random{1};
  for (int trial = 0; trial < 40; ++trial) {
    const Marker marker = two_shapes(random);
    Pair pair{marker};
    const auto& p = pair.turned(0, static_cast<std::size_t>(trial) % 8);
    const auto& q = pair.turned(1, static_cast<std::size_t>(trial) / 8);
    const Polygon first = oriented_outline(marker, 0, p);
    const Polygon second = oriented_outline(marker, 1, q);
    for (int point = 0; point < 50; ++point) {
      const Vec at{random.between(-3 * test::kSide, 3 * test::kSide),
                   random.between(-3 * test::kSide, 3 * test::kSide)};
      const float depth = pair.maps.view(p, q).depth(static_cast<float>(at.x) / 1000, static_cast<float>(at.y) / 1000);
      const float swapped =
          pair.maps.view(q, p).depth(static_cast<float>(-at.x) / 1000, static_cast<float>(-at.y) / 1000);
      EXPECT_NEAR(depth, swapped, 0.01) << "trial " << trial;
      const bool overlaps = geometry::overlap({first, box_of(first), {}}, {second, box_of(second), at});
      EXPECT_TRUE(depth <= 0.01F || overlaps) << "trial " << trial << ", depth " << depth;
      if (depth == 0 && overlaps) {
        // They may differ only by what floats cannot resolve.
        bool apart = false;
        for (const Vec by : {Vec{20, 0}, Vec{-20, 0}, Vec{0, 20}, Vec{0, -20}}) {
          apart = apart || !geometry::overlap({first, box_of(first), {}}, {second, box_of(second), at + by});
        }
        EXPECT_TRUE(apart) << "trial " << trial;
      }
    }
  }
}

TEST(DepthMap, IsTheDistanceToTheNearestFreePosition) {
  const Marker marker = test::unplaced_pieces({test::rectangle(100'000, 200'000)}, 2, kWidth);
  Pair pair{marker};
  const MapView view = pair.maps.view(pair.turned(0, 0), pair.turned(1, 0));
  EXPECT_NEAR(view.depth(0, 0), 100, 1e-3);
  EXPECT_NEAR(view.depth(70, 0), 30, 1e-3);
  EXPECT_NEAR(view.depth(-70, 190), 10, 1e-3);
  EXPECT_EQ(view.depth(100, 0), 0);
  EXPECT_EQ(view.depth(0, 201), 0);
  const MapView upright_and_lying = pair.maps.view(pair.turned(0, 0), pair.turned(1, 1));
  EXPECT_NEAR(upright_and_lying.depth(20, 50), 20, 1e-3);  // the second one lies from -200 to 0 of its own x
  EXPECT_NEAR(upright_and_lying.depth(280, 50), 20, 1e-3);
}

TEST(DepthMap, IncludesTheClearance) {
  Marker marker = test::unplaced_pieces({test::rectangle(100'000, 200'000)}, 2, kWidth);
  marker.spacing = 3'000;
  marker.unplaced[0].buffer = marker.unplaced[1].buffer = 5'000;
  Pair pair{marker};
  const MapView view = pair.maps.view(pair.turned(0, 0), pair.turned(1, 0));
  EXPECT_NEAR(view.depth(105, 0), 5, 1e-3);
  EXPECT_EQ(view.depth(110.01F, 0), 0);
  EXPECT_NEAR(view.depth(106, 208), 0, 1e-3);  // beyond a corner the Euclidean distance counts, not that along the axes
  EXPECT_NEAR(view.depth(103, 204), 5, 1e-3);
}

TEST(DepthMap, ItsGridHoldsTheChargedDepths) {
  Random random{2};
  for (int trial = 0; trial < 20; ++trial) {
    const Marker marker = two_shapes(random);
    Pair pair{marker};
    const DepthMap& map = *pair.maps.view(pair.turned(0, 0), pair.turned(1, 0)).map;
    const DepthMap::Grid grid = map.grid();
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const std::int16_t sample = grid.samples[row * grid.columns + column];
        const float depth = map.depth(static_cast<float>(grid.first_column + column) * kScale.pixel,
                                      static_cast<float>(grid.first_row + row) * kScale.pixel);
        const float read = static_cast<float>(sample) * kScale.pixel * DepthMap::kSample;
        EXPECT_TRUE(depth <= 0.1F || std::abs(read - depth - kScale.charge) < 0.1F) << "trial " << trial;
        EXPECT_TRUE(read >= -0.1F || depth == 0) << "trial " << trial;
      }
    }
  }
}

TEST(DepthMap, ItsOverlapsAreThePositiveSamplesRoundedUp) {
  Random random{6};
  for (int trial = 0; trial < 20; ++trial) {
    const Marker marker = two_shapes(random);
    Pair pair{marker};
    DepthMap& map = *pair.maps.view(pair.turned(0, 0), pair.turned(1, 0)).map;
    const DepthMap::Grid grid = map.grid();
    const DepthMap::Overlaps overlaps = map.overlaps();
    const DepthMap::Overlaps transposed = map.transposed_overlaps();
    ASSERT_EQ(overlaps.columns, transposed.rows);
    ASSERT_EQ(overlaps.first_row, transposed.first_column);
    std::uint8_t most = 0;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const float sample =
            static_cast<float>(grid.samples[row * grid.columns + column]) * kScale.pixel * DepthMap::kSample;
        const int own_column = grid.first_column + column - overlaps.first_column;
        const int own_row = grid.first_row + row - overlaps.first_row;
        if (own_column < 0 || own_column >= overlaps.columns || own_row < 0 || own_row >= overlaps.rows) {
          EXPECT_LE(sample, 0) << "trial " << trial;
          continue;
        }
        const std::uint8_t overlap = overlaps.samples[own_row * overlaps.columns + own_column];
        EXPECT_EQ(overlap, transposed.samples[own_column * transposed.columns + own_row]);
        EXPECT_EQ(overlap > 0, sample > 0) << "trial " << trial;
        const float read = static_cast<float>(overlap) * overlaps.unit;
        EXPECT_TRUE(overlap == 0 || (read >= sample - 1e-3F && read < sample + 1.001F * overlaps.unit))
            << "trial " << trial;
        most = std::max(most, overlap);
      }
    }
    EXPECT_EQ(most, 255);
  }
}

TEST(DepthMap, ItsGridHoldsTheDistanceToTheWholeBoundary) {
  Random random{4};
  for (int trial = 0; trial < 20; ++trial) {
    const Marker marker = two_shapes(random);
    Pair pair{marker};
    const DepthMap& map = *pair.maps.view(pair.turned(0, 0), pair.turned(1, 0)).map;
    const DepthMap::Grid grid = map.grid();
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const float read = static_cast<float>(grid.samples[row * grid.columns + column]) * kScale.pixel;
        const float depth = read * DepthMap::kSample - (read > 0 ? kScale.charge : 0);
        const float distance =
            std::sqrt(nearness(map.boundary(), static_cast<float>(grid.first_column + column) * kScale.pixel,
                               static_cast<float>(grid.first_row + row) * kScale.pixel)
                          .squared_distance);
        EXPECT_NEAR(std::abs(depth), distance, kScale.pixel * DepthMap::kSample) << "trial " << trial;
      }
    }
  }
}

TEST(DepthMap, PiecesThatMayNotMeetHaveNoDepth) {
  Random random{5};
  int apart = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Marker marker = two_shapes(random);
    marker.spacing = trial % 2 == 0 ? 0 : 20'000;
    Pair pair{marker};
    const auto& p = pair.turned(0, static_cast<std::size_t>(trial) % 8);
    const auto& q = pair.turned(1, static_cast<std::size_t>(trial) / 8);
    for (int point = 0; point < 50; ++point) {
      const auto coordinate = [&] {
        return static_cast<double>(random.between(-3 * test::kSide, 3 * test::kSide)) / 1000;
      };
      const layout::Place at{coordinate(), coordinate(), 0};
      if (may_meet(pair.set, p, {}, q, at, 0)) continue;
      ++apart;
      EXPECT_LE(pair.maps.view(p, q).depth(static_cast<float>(at.x), static_cast<float>(at.y)), 0.01F);
    }
  }
  EXPECT_GT(apart, 100);
}

TEST(DepthMaps, ForgetsNothingButMemory) {
  Random random{3};
  const Marker marker = two_shapes(random);
  Pair pair{marker};
  const float before = pair.maps.view(pair.turned(0, 2), pair.turned(1, 5)).depth(10, 20);
  DepthMaps small{pair.set, kScale, 0};
  (void)small.view(pair.turned(0, 2), pair.turned(1, 5));
  small.trim();
  EXPECT_EQ(small.view(pair.turned(0, 2), pair.turned(1, 5)).depth(10, 20), before);
}

}  // namespace
}  // namespace selvage::nesting::depth
