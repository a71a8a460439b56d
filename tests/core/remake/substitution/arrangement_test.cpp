#include "core/remake/substitution/arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/remake/substitution/choice.h"
#include "tests/core/remake/orders.h"
#include "tests/laws/random_marker.h"
#include "tests/support/garment.h"

namespace selvage::remake::substitution {
namespace {

TEST(Arrangement, HasASlotForEveryPlacedPiece) {
  const Marker marker = test::garment("jeans_02g");
  const auto arrangement = arrangement_of(test::unlabelled(marker), 3, marker.resolution);
  ASSERT_TRUE(arrangement);
  EXPECT_EQ(arrangement->slots.size(), marker.pieces.size());
  EXPECT_EQ(arrangement->stored, (std::vector<std::size_t>{3}));
  EXPECT_EQ(arrangement->length, length_of(marker));
  EXPECT_FALSE(arrangement_of(test::unlabelled(test::order_of(marker)), 0, marker.resolution));
}

TEST(Arrangement, IsExactOnAFinerLattice) {
  const Marker marker = test::garment("jeans_02g");
  const auto fine = arrangement_of(test::unlabelled(marker), 0, Resolution{marker.resolution.exponent - 1});
  const auto own = arrangement_of(test::unlabelled(marker), 0, marker.resolution);
  ASSERT_TRUE(fine && own);
  EXPECT_EQ(fine->length, 10 * own->length);
  for (std::size_t k = 0; k < own->slots.size(); ++k) {
    EXPECT_EQ(fine->slots[k].at, (Vec{10 * own->slots[k].at.x, 10 * own->slots[k].at.y}));
  }
}

TEST(Arrangement, IsRefusedWhereTheLatticeEnds) {
  const Marker marker = test::garment("jeans_02g");
  EXPECT_FALSE(arrangement_of(test::unlabelled(marker), 0, Resolution{-20}));
}

TEST(Arrangement, ConcatenatedLiesOneBehindTheOther) {
  const Marker marker = test::garment("jeans_02g");
  const auto own = arrangement_of(test::unlabelled(marker), 0, marker.resolution);
  const auto both = concatenated(*own, *own);
  ASSERT_TRUE(both);
  EXPECT_EQ(both->length, 2 * own->length);
  EXPECT_EQ(both->slots.size(), 2 * own->slots.size());
  EXPECT_EQ(both->slots.back().at.x, own->slots.back().at.x + own->length);
  EXPECT_EQ(both->stored, (std::vector<std::size_t>{0, 0}));
}

TEST(Candidates, AreTheMarkersAsLargeAsTheOrder) {
  const Marker jeans = test::garment("jeans_02g");
  const std::vector<Marker> stored{test::garment("jeans_22g"), jeans, test::garment("jeans_06g")};
  const auto found =
      candidates_for(test::unlabelled(test::order_of(jeans)), test::unlabelled(stored), true, {}, serial());
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].arrangement.stored, (std::vector<std::size_t>{1}));
  EXPECT_EQ(found[0].difference, 0);
  EXPECT_NEAR(found[0].predicted, utilisation_of(jeans), 1e-9);
  for (const Candidate& candidate : found) EXPECT_EQ(candidate.arrangement.stored.size(), 1U);
}

TEST(Candidates, IncludeConcatenationsForLongOrders) {
  const Marker jeans = test::garment("jeans_02g");
  Marker order = test::order_of(jeans);
  for (std::size_t k = 0; k < jeans.pieces.size(); ++k) {
    Piece piece = order.unplaced[k];
    piece.id += "+";
    order.unplaced.push_back(piece);
  }
  const std::vector<Marker> stored{jeans};
  const auto found = candidates_for(test::unlabelled(order), test::unlabelled(stored), true, {}, serial());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].arrangement.stored, (std::vector<std::size_t>{0, 0}));
  EXPECT_EQ(found[0].difference, 0);
  EXPECT_TRUE(candidates_for(test::unlabelled(order), test::unlabelled(stored), false, {}, serial()).empty());

  std::size_t ways = 0;
  for (const Shape& shape : order.shapes) ways += matching::orientations_of(shape, {}).size();
  RemakeTuning tuning;
  tuning.most_compared = std::max(ways, order.unplaced.size()) * 2 * jeans.pieces.size();
  EXPECT_EQ(candidates_for(test::unlabelled(order), test::unlabelled(stored), true, tuning, serial()).size(), 1U);
  --tuning.most_compared;
  EXPECT_TRUE(candidates_for(test::unlabelled(order), test::unlabelled(stored), true, tuning, serial()).empty());
}

TEST(Candidates, AreNotTooManyPiecesToCompare) {
  const Marker jeans = test::garment("jeans_02g");
  const auto order = test::unlabelled(test::order_of(jeans));
  const std::vector<Marker> stored{jeans};
  RemakeTuning tuning;
  tuning.most_compared = jeans.pieces.size() * jeans.pieces.size() - 1;
  EXPECT_TRUE(candidates_for(order, test::unlabelled(stored), true, tuning, serial()).empty());
}

TEST(Candidates, AreNoneWhenCancelled) {
  const Marker jeans = test::garment("jeans_02g");
  const auto order = test::unlabelled(test::order_of(jeans));
  const std::vector<Marker> stored{jeans};
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(candidates_for(order, test::unlabelled(stored), true, {}, serial(), stop.get_token()).empty());
}

}  // namespace
}  // namespace selvage::remake::substitution
