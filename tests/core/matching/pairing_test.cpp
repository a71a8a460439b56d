#include "core/matching/pairing.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/garment.h"
#include "tests/support/random.h"

namespace selvage::matching {
namespace {

std::vector<Slot> slots_of(const Marker& marker) {
  std::vector<Slot> slots;
  for (const Piece& piece : marker.pieces) {
    const Shape& shape = marker.shapes[piece.shape.value];
    slots.push_back(slot_of(shape, piece.orientation, piece.at));
  }
  return slots;
}

TEST(Pairing, OfAMarkersOwnPiecesHasNoDifference) {
  for (const char* name : {"jeans_02g", "simon_06g"}) {
    const Marker marker = test::garment(name);
    const std::vector<Slot> slots = slots_of(marker);
    const Pairing pairing = pair_pieces(marker, slots);
    EXPECT_EQ(pairing.difference, 0);
    std::set<std::size_t> taken;
    for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
      ASSERT_TRUE(pairing.pairs[k]);
      taken.insert(pairing.pairs[k]->slot);
      Polygon lies = oriented(marker.shapes[marker.pieces[k].shape.value].outline, pairing.pairs[k]->orientation);
      EXPECT_EQ(box_of(lies).width(), box_of(slots[pairing.pairs[k]->slot].outline).width());
    }
    EXPECT_EQ(taken.size(), marker.pieces.size());
  }
}

TEST(Pairing, LeavesOutPiecesThatMatchNoSlot) {
  Marker order = test::garment("jeans_02g");
  std::vector<Slot> slots = slots_of(order);
  Shape long_bar;
  long_bar.id = "bar";
  const Coord width = order.strip.width;
  long_bar.outline = {{0, 0}, {5 * width, 0}, {5 * width, width / 20}, {0, width / 20}};
  order.shapes.push_back(long_bar);
  Piece bar;
  bar.id = "bar";
  bar.shape = ShapeId{static_cast<std::uint32_t>(order.shapes.size() - 1)};
  order.unplaced.push_back(bar);
  const Pairing more = pair_pieces(order, slots);
  EXPECT_FALSE(more.pairs.back());
  EXPECT_DOUBLE_EQ(more.difference, 5.0 * static_cast<double>(width) * static_cast<double>(width / 20));

  order.unplaced.clear();
  order.pieces.pop_back();
  const Pairing fewer = pair_pieces(order, slots);
  for (const auto& pair : fewer.pairs) EXPECT_TRUE(pair);
  EXPECT_GT(fewer.difference, 0);
}

TEST(Pairing, UsesAllowedOrientationsOnly) {
  test::Random random{9};
  Marker order = test::garment("jeans_02g");
  std::vector<Slot> slots = slots_of(order);
  for (Slot& slot : slots) {
    const Symmetry turn{false, random.chance(50) ? 2 : 0};
    for (Polygon* outline : {&slot.outline, &slot.untilted}) *outline = transformed(*outline, turn);
  }
  const Pairing pairing = pair_pieces(order, slots);
  for (std::size_t k = 0; k < order.pieces.size(); ++k) {
    if (!pairing.pairs[k]) continue;
    const Shape& shape = order.shapes[order.pieces[k].shape.value];
    EXPECT_NE(std::find(shape.rotations.begin(), shape.rotations.end(), pairing.pairs[k]->orientation.rotation),
              shape.rotations.end());
    EXPECT_FALSE(pairing.pairs[k]->orientation.flip && !shape.may_flip);
  }
}

TEST(Orientations, TakeTheSlotsTiltWhereItIsAllowed) {
  Shape shape;
  shape.rotations = {Angle{0}, Angle{180}};
  shape.tilt_limit = Angle{1};
  for (const double tilt : {0.5, -1.5}) {
    const std::vector<Orientation> orientations = orientations_of(shape, {{}, {}, Angle{tilt}});
    ASSERT_EQ(orientations.size(), 2U);
    for (const Orientation& one : orientations) EXPECT_EQ(one.tilt, tilt == 0.5 ? Angle{tilt} : Angle{});
  }
  shape.may_flip = true;
  EXPECT_EQ(orientations_of(shape, {}).size(), 4U);
  shape.rotations.clear();
  EXPECT_EQ(orientations_of(shape, {{}, Angle{30}, {}}).size(), 8U);
}

}  // namespace
}  // namespace selvage::matching
