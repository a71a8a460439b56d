// Tests of core/nesting/fields and local_search: a field is the sum of the pairs' losses at every position, however the
// maps are turned and whatever it has held before, and losses follow the moves.
#include "core/nesting/fields/field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/nesting/fields/kept_fields.h"
#include "core/nesting/local_search/guided_search.h"
#include "core/nesting/local_search/neighbourhood.h"
#include "tests/core/nesting/unplaced_pieces.h"

namespace selvage::nesting::local_search {
namespace {

using fields::Candidate;
using fields::Field;
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
  std::vector<float> weights = std::vector<float>(6, 1);
};

std::vector<Candidate> candidates_of(const Field& field) {
  layout::Dice dice{1};
  std::vector<Candidate> candidates;
  field.append_lowest(1000, dice, candidates);
  return candidates;
}

TEST(Field, ItsLowestPlacesHaveTheReportedLosses) {
  Random random{4};
  for (int trial = 0; trial < 20; ++trial) {
    Scattered scattered{random};
    Field field{scattered.set, scattered.maps};
    Neighbourhood neighbourhood{scattered.set, scattered.maps, scattered.losses};
    neighbourhood.take(scattered.layout);
    for (std::uint32_t turn = 0; turn < scattered.set.kind(0).turned.size(); ++turn) {
      std::vector<float> weights(6);
      for (std::size_t other = 0; other < 6; ++other) weights[other] = scattered.losses.importance(0, other);
      if (!field.compute(scattered.layout, 0, turn, weights)) continue;
      const std::vector<Candidate> candidates = candidates_of(field);
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
    Field field{scattered.set, scattered.maps};
    for (std::uint32_t turn = 0; turn < scattered.set.kind(0).turned.size(); ++turn) {
      const RealBox fit = inner_fit(scattered.set, scattered.layout, 0, turn);
      const double x = std::clamp(scattered.layout.places[0].x, fit.low_x, fit.high_x);
      if (!field.compute(scattered.layout, 0, turn, scattered.weights, kReach)) continue;
      const std::vector<Candidate> candidates = candidates_of(field);
      ASSERT_FALSE(candidates.empty());
      for (const Candidate& candidate : candidates) {
        EXPECT_LE(std::abs(candidate.place.x - x), kReach + 1e-9) << "trial " << trial;
      }
    }
  }
}

// Another layout, and other weights: some pieces move, and some stay where they are.
void change(Scattered& scattered, Random& random) {
  for (std::size_t i = 1; i < scattered.set.size(); ++i) {
    if (random.below(2) == 0) {
      scattered.layout.places[i].turn = static_cast<std::uint32_t>(random.below(scattered.set.kind(i).turned.size()));
      centre_at(scattered.set, scattered.layout, i, static_cast<double>(random.below(1200)),
                static_cast<double>(random.below(1000)));
    }
    if (random.below(3) == 0) scattered.weights[i] = static_cast<float>(random.below(300)) / 100;
  }
}

TEST(Field, IsTheSameWhenOnlyChangesAreAdded) {
  Random random{7};
  for (int trial = 0; trial < 20; ++trial) {
    Scattered scattered{random};
    Field kept{scattered.set, scattered.maps};
    for (int step = 0; step < 20; ++step) {
      Field anew{scattered.set, scattered.maps};
      const bool fits = kept.compute(scattered.layout, 0, 0, scattered.weights);
      ASSERT_EQ(fits, anew.compute(scattered.layout, 0, 0, scattered.weights));
      if (!fits) break;
      const std::vector<Candidate> ours = candidates_of(kept);
      const std::vector<Candidate> theirs = candidates_of(anew);
      ASSERT_EQ(ours.size(), theirs.size());
      for (std::size_t k = 0; k < ours.size(); ++k) {
        // Weights are rounded to units, of which each sample counts up to 255.
        EXPECT_NEAR(ours[k].loss, theirs[k].loss, 0.05 + 1e-3 * static_cast<double>(theirs[k].loss)) << "step " << step;
      }
      change(scattered, random);
    }
  }
}

TEST(Field, ChangesThatAreTakenBackLeaveNothing) {
  Random random{8};
  for (int trial = 0; trial < 20; ++trial) {
    Scattered scattered{random};
    const Layout first = scattered.layout;
    Field field{scattered.set, scattered.maps};
    if (!field.compute(first, 0, 0, scattered.weights)) continue;
    const std::vector<Candidate> before = candidates_of(field);
    for (int step = 0; step < 50; ++step) {
      change(scattered, random);
      ASSERT_TRUE(field.compute(scattered.layout, 0, 0, scattered.weights));
    }
    ASSERT_TRUE(field.compute(first, 0, 0, std::vector<float>(6, 1)));
    const std::vector<Candidate> after = candidates_of(field);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_EQ(before[k].loss, after[k].loss);
      EXPECT_EQ(before[k].place.x, after[k].place.x);
      EXPECT_EQ(before[k].place.y, after[k].place.y);
    }
  }
}

TEST(Field, NoWeightIsSoLargeThatOthersCountNothing) {
  Random random{9};
  int rows = 0;
  for (int trial = 0; trial < 20; ++trial) {
    Scattered scattered{random};
    scattered.layout.length = 330;  // so short that a piece in its middle leaves whole rows without a free place
    centre_at(scattered.set, scattered.layout, 2, 165, 500);
    const std::vector<float> equal{0, 0, 1, 0, 0, 0};
    const std::vector<float> unequal{0, 1e20F, 1, 0, 0, 0};
    Field field{scattered.set, scattered.maps};
    if (!field.compute(scattered.layout, 0, 0, equal)) continue;
    std::map<double, float> alone;  // losses by y
    for (const Candidate& candidate : candidates_of(field)) alone[candidate.place.y] = candidate.loss;
    ASSERT_TRUE(field.compute(scattered.layout, 0, 0, unequal));
    for (const Candidate& candidate : candidates_of(field)) {
      if (alone.at(candidate.place.y) <= 0) continue;
      EXPECT_GT(candidate.loss, 0);
      ++rows;
    }
    ASSERT_TRUE(field.compute(scattered.layout, 0, 0, equal));
    for (const Candidate& candidate : candidates_of(field)) {
      EXPECT_NEAR(candidate.loss, alone.at(candidate.place.y), 1e-2) << "after a large weight";
    }
  }
  EXPECT_GT(rows, 100);
}

TEST(KeptFields, AreAsManyAsMemoryAllows) {
  Random random{10};
  Scattered scattered{random};
  fields::KeptFields many{scattered.set, scattered.maps, 1 << 20};
  fields::Field& first = many.of(0, 0);
  (void)first.compute(scattered.layout, 0, 0, scattered.weights);
  EXPECT_NE(&many.of(0, 1), &first);
  EXPECT_NE(&many.of(1, 0), &first);
  EXPECT_EQ(&many.of(0, 0), &first);
  fields::KeptFields none{scattered.set, scattered.maps, 0};
  fields::Field& shared = none.of(0, 0);
  EXPECT_EQ(&none.of(1, 0), &shared);
  EXPECT_EQ(&none.of(0, 0), &shared);
}

TEST(Losses, FollowEveryMove) {
  Random random{5};
  for (int trial = 0; trial < 10; ++trial) {
    Scattered scattered{random};
    layout::Dice dice{2};
    Mover mover{scattered.set, scattered.maps, scattered.losses, dice, scattered.tuning, 1 << 20};
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
  GuidedSearch search{*set, 1, 1 << 24, {}, {}};
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
