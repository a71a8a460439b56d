#include "core/model/ties.h"

#include <gtest/gtest.h>

namespace selvage::model {
namespace {

using Numbers = std::vector<std::uint32_t>;

Marker pieces(std::size_t count) {
  Marker marker;
  marker.pieces.resize(count);
  return marker;
}

TEST(Ties, DoNotTieFreePieces) {
  const Ties ties = ties_of(pieces(2));
  EXPECT_EQ(ties.x, (Numbers{0, 1}));
  EXPECT_TRUE(ties.free(0));
  EXPECT_FALSE(ties.joined(0, 1));
}

TEST(Ties, FixAPieceOnTheAxisItIsLockedOn) {
  Marker marker = pieces(3);
  marker.pieces[0].locked = {true, false, false};
  marker.pieces[1].locked = {true, true, false};
  const Ties ties = ties_of(marker);
  EXPECT_EQ(ties.x, (Numbers{Ties::kFixed, Ties::kFixed, 2}));
  EXPECT_EQ(ties.y, (Numbers{0, Ties::kFixed, 2}));
  EXPECT_FALSE(ties.fixed(0));
  EXPECT_FALSE(ties.free(0));
  EXPECT_TRUE(ties.fixed(1));
}

TEST(Ties, ALockOfOnePieceAppliesToItsWholeGroup) {
  Marker marker = pieces(4);
  marker.pieces[0].group = marker.pieces[2].group = marker.pieces[3].group = "g";
  marker.pieces[3].locked = {false, true, false};
  const Ties ties = ties_of(marker);
  EXPECT_EQ(ties.x, (Numbers{0, 1, 0, 0}));
  EXPECT_EQ(ties.y, (Numbers{Ties::kFixed, 1, Ties::kFixed, Ties::kFixed}));
  EXPECT_TRUE(ties.joined(0, 3));
}

TEST(Ties, JoinPiecesThatAreTiedToEither) {
  Ties ties = ties_of(pieces(5));
  ties.join(1, 2);
  ties.join(3, 4);
  ties.join(2, 4);
  EXPECT_EQ(ties.x, (Numbers{0, 1, 1, 1, 1}));
  ties.x[0] = Ties::kFixed;
  ties.join(0, 3);
  EXPECT_EQ(ties.x, (Numbers{Ties::kFixed, Ties::kFixed, Ties::kFixed, Ties::kFixed, Ties::kFixed}));
  EXPECT_EQ(ties.y, (Numbers{0, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace selvage::model
