#include "core/matching/signature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/garment.h"

namespace selvage::matching {
namespace {

TEST(Signature, OfTheSameOrderIsAtDistanceZero) {
  const Marker marker = test::garment("jeans_06g");
  Marker order = marker;
  order.unplaced = order.pieces;
  order.pieces.clear();
  EXPECT_EQ(distance_between(signature_of(marker), signature_of(order)), 0);
}

TEST(Signature, ExcludesOtherUnitsWidthsAndSpacings) {
  const Marker marker = test::garment("jeans_02g");
  const Signature own = signature_of(marker);
  Marker other = marker;
  other.unit = "inch";
  EXPECT_TRUE(std::isinf(distance_between(own, signature_of(other))));
  other = marker;
  other.strip.width += other.strip.width / 50;
  EXPECT_TRUE(std::isinf(distance_between(own, signature_of(other))));
  other = marker;
  other.spacing = other.strip.width / 500;
  EXPECT_TRUE(std::isinf(distance_between(own, signature_of(other))));
}

TEST(Signature, RanksTheSameGarmentFirst) {
  std::vector<Signature> stored;
  for (const char* name : {"simon_06g", "charlie_04g", "jeans_06g"}) {
    Marker marker = test::garment(name);
    marker.strip.width = test::garment("jeans_06g").strip.width;
    stored.push_back(signature_of(marker));
  }
  const Signature order = signature_of(test::garment("jeans_06g"));
  const auto found = nearest(order, stored, 2);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], 2U);
  EXPECT_EQ(found[1], 1U);
  EXPECT_EQ(nearest(order, stored, 10).size(), 3U);
}

TEST(Signature, RanksHalfOfTheBundlesAlmostAsHighAsAll) {
  const Marker marker = test::garment("jeans_02g");
  Marker twice = marker;
  for (Piece piece : marker.pieces) {
    piece.id += "+";
    twice.unplaced.push_back(piece);
  }
  const double distance = distance_between(signature_of(twice), signature_of(marker));
  EXPECT_GT(distance, 0);
  EXPECT_LT(distance, 0.2);
}

}  // namespace
}  // namespace selvage::matching
