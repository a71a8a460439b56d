// Tests of core/nesting/local_search: a field is the sum of the pairs' losses at every position, however the maps are
// turned, and losses follow the moves.
#include "core/nesting/local_search/field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/nesting/local_search/guided_search.h"
#include "core/nesting/local_search/neighbourhood.h"
#include "tests/core/nesting/unplaced_pieces.h"

namespace selvage::nesting::local_search {
namespace {

using layout::Layout;
using test::kWidth;
using test::Random;

constexpr depth::MapScale kScale{.pixel = 4, .charge = 5};

// Six random pieces, each somewhere in one of its eight orientations.
struct Scattered {
  explicit Scattered(Random& random)
      : marker{[&] {
          std::vector<Polygon> outlines;
          for (int k = 0; k < 3; ++k) outlines.push_back(test::random_polygon(random, 3 * test::kSide));
          Marker made = test::unplaced_pieces(outlines, 6, kWidth);
          for (Shape& shape : made.shapes) shape.may_flip = true;
          return made;
        }()},
        set{*piece_set_of(marker, layout::PlacedPiecesMay::kMove, sums)},
        maps{set, kScale, 1 << 24},
        losses{set, maps, tuning} {
    layout.length = 1200;
    for (std::size_t i = 0; i < set.size(); ++i) {
      layout.places.push_back({0, 0, static_cast<std::uint32_t>(random.below(set.kind(i).turned.size()))});
      centre_at(set, layout, i, static_cast<double>(random.below(1200)), static_cast<double>(random.below(1000)));
    }
    losses.reset(layout);
  }

  Marker marker;
  SumCache sums;
  layout::PieceSet set;
  depth::DepthMaps maps;
  SearchTuning tuning;
  Losses losses;
  Layout layout;
  std::vector<std::uint32_t> all{0, 1, 2, 3, 4, 5};
};

TEST(Field, ItsLowestPlacesHaveTheReportedLosses) {
  Random random{4};
  for (int trial = 0; trial < 20; ++trial) {
    Scattered scattered{random};
    layout::Dice dice{1};
    Field field{scattered.set, scattered.maps};
    Neighbourhood neighbourhood{scattered.set, scattered.maps, scattered.losses};
    neighbourhood.take(scattered.layout);
    for (std::uint32_t turn = 0; turn < scattered.set.kind(0).turned.size(); ++turn) {
      if (!field.compute(scattered.layout, 0, turn, scattered.all, scattered.losses, FieldWeights::kGuided)) continue;
      std::vector<Candidate> candidates;
      field.append_lowest(1000, dice, candidates);
      ASSERT_FALSE(candidates.empty());
      for (const Candidate& candidate : candidates) {
        neighbourhood.gather(scattered.layout, 0, candidate.place, 1);
        const double exact = neighbourhood.loss(candidate.place.x, candidate.place.y, 1e30);
        // Maps are read at the nearest pixel, so each of the other pieces may be off by a pixel's diagonal and, at its
        // boundary, by the charge.
        EXPECT_NEAR(candidate.loss, exact, 5 * 2.0 * (kScale.pixel + kScale.charge)) << "trial " << trial;
      }
    }
  }
}

TEST(Field, HasNoPlacesBeyondItsReach) {
  Random random{6};
  constexpr double kReach = 100;
  for (int trial = 0; trial < 20; ++trial) {
    Scattered scattered{random};
    layout::Dice dice{1};
    Field field{scattered.set, scattered.maps};
    for (std::uint32_t turn = 0; turn < scattered.set.kind(0).turned.size(); ++turn) {
      const layout::RealBox fit = inner_fit(scattered.set, scattered.layout, 0, turn);
      const double x = std::clamp(scattered.layout.places[0].x, fit.low_x, fit.high_x);
      if (!field.compute(scattered.layout, 0, turn, scattered.all, scattered.losses, FieldWeights::kGuided, kReach)) {
        continue;
      }
      std::vector<Candidate> candidates;
      field.append_lowest(1000, dice, candidates);
      ASSERT_FALSE(candidates.empty());
      for (const Candidate& candidate : candidates) {
        EXPECT_LE(std::abs(candidate.place.x - x), kReach + 1e-9) << "trial " << trial;
      }
    }
  }
}

TEST(Losses, FollowEveryMove) {
  Random random{5};
  for (int trial = 0; trial < 10; ++trial) {
    Scattered scattered{random};
    layout::Dice dice{2};
    Mover mover{scattered.set, scattered.maps, scattered.losses, dice, scattered.tuning};
    for (std::size_t piece = 0; piece < scattered.set.size(); ++piece) {
      const double before = scattered.losses.total();
      mover.move(scattered.layout, piece);
      EXPECT_LE(scattered.losses.total(), before + 1e-3) << "with all weights at 1, no move may make it worse";
      Losses anew{scattered.set, scattered.maps, scattered.tuning};
      anew.reset(scattered.layout);
      EXPECT_NEAR(scattered.losses.total(), anew.total(), 1e-6);
      scattered.losses.reset(scattered.layout);
    }
  }
}

TEST(Neighbourhood, KeptEdgesGiveTheSameLosses) {
  Random random{6};
  for (int trial = 0; trial < 20; ++trial) {
    Scattered scattered{random};
    Neighbourhood whole{scattered.set, scattered.maps, scattered.losses};
    Neighbourhood kept{scattered.set, scattered.maps, scattered.losses};
    const layout::Place place = scattered.layout.places[0];
    constexpr double kReach = 6;
    whole.take(scattered.layout);
    kept.take(scattered.layout);
    whole.gather(scattered.layout, 0, place, kReach);
    kept.gather(scattered.layout, 0, place, kReach);
    kept.keep_edges(place, kReach);
    for (int point = 0; point < 100; ++point) {
      const double x = place.x + kReach * (2.0 * static_cast<double>(random.below(1000)) / 1000 - 1);
      const double y = place.y + kReach * (2.0 * static_cast<double>(random.below(1000)) / 1000 - 1);
      EXPECT_NEAR(kept.loss(x, y, 1e30), whole.loss(x, y, 1e30), 1e-2) << "trial " << trial;
    }
  }
}

TEST(GuidedSearch, SeparatesPiecesThatLieOnEachOther) {
  const Marker marker =
      test::unplaced_pieces({test::rectangle(200'000, 300'000), test::rectangle(150'000, 150'000)}, 8, kWidth);
  SumCache sums;
  const auto set = piece_set_of(marker, layout::PlacedPiecesMay::kMove, sums);
  ASSERT_TRUE(set);
  GuidedSearch search{*set, 1, 1 << 24, {}};
  Layout heap;
  heap.length = 700;
  heap.places.resize(8);
  for (std::size_t i = 0; i < 8; ++i) centre_at(*set, heap, i, 350, 500);
  const auto outcome = search.separate(heap, {200, 3}, [] { return false; });
  EXPECT_EQ(outcome.loss, 0);
  const auto at_once = search.separate(heap, {200, 3}, [] { return true; });
  EXPECT_GT(at_once.loss, 0);
}

}  // namespace
}  // namespace selvage::nesting::local_search
