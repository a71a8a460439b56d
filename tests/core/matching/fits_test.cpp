#include "core/matching/fits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/garment.h"

namespace selvage::matching {
namespace {

std::vector<Slot> tilted_slots_of(const Marker& marker, Angle tilt) {
  std::vector<Slot> slots;
  for (const Piece& piece : marker.pieces) {
    Orientation orientation = piece.orientation;
    orientation.tilt = tilt;
    slots.push_back(slot_of(marker.shapes[piece.shape.value], orientation, piece.at));
  }
  return slots;
}

TEST(Fits, AreSortedByCostAndHaveEveryOrientation) {
  const Marker marker = test::garment("jeans_02g");
  const std::vector<Slot> slots = tilted_slots_of(marker, {});
  const FitTable table{marker, slots};
  for (std::uint32_t shape = 0; shape < marker.shapes.size(); ++shape) {
    for (std::size_t slot = 0; slot < slots.size(); slot += 7) {
      const std::vector<Fit> fits = table.all(ShapeId{shape}, slot);
      EXPECT_EQ(fits.size(), orientations_of(marker.shapes[shape], slots[slot].orientation).size());
      EXPECT_TRUE(std::ranges::is_sorted(fits, {}, &Fit::cost));
      EXPECT_EQ(fits.front().cost, table.best(ShapeId{shape}, slot).cost);
      for (const Fit& fit : fits) EXPECT_GE(fit.cost, fit.difference);
    }
  }
}

// A piece does not differ from its own slot, however that is tilted, and adopts the tilt if allowed.
TEST(Fits, TiltsAreAdoptedAtNoCost) {
  Marker marker = test::garment("jeans_02g");
  const std::vector<Slot> slots = tilted_slots_of(marker, Angle{0.5});
  for (const double limit : {1.0, 0.25}) {
    for (Shape& shape : marker.shapes) shape.tilt_limit = Angle{limit};
    const FitTable table{marker, slots};
    for (std::size_t k = 0; k < slots.size(); ++k) {
      const Fit fit = table.best(marker.pieces[k].shape, k);
      EXPECT_EQ(fit.difference, 0);
      EXPECT_EQ(fit.orientation.tilt, limit == 1.0 ? Angle{0.5} : Angle{});
    }
  }
}

// A rectangle looks the same when it is flipped or rotated by 180 degrees, but its tilted outline is rounded
// differently.
TEST(Fits, PiecesThatLookTheSameInSeveralOrientationsKeepTheirOwn) {
  Marker marker;
  Shape& shape = marker.shapes.emplace_back();
  shape.outline = {{0, 0}, {241, 0}, {241, 439}, {0, 439}};
  shape.may_flip = true;
  shape.tilt_limit = Angle{3};
  for (const std::vector<Angle>& rotations :
       {std::vector<Angle>{}, std::vector{Angle{0}, Angle{90}, Angle{180}, Angle{270}}}) {
    shape.rotations = rotations;
    std::vector<Slot> slots;
    for (const bool flip : {false, true}) {
      for (const double rotation : {0, 90, 180, 270}) {
        slots.push_back(slot_of(shape, {flip, Angle{rotation}, Angle{2.9}}, {}));
      }
    }
    const FitTable table{marker, slots};
    for (std::size_t k = 0; k < slots.size(); ++k)
      EXPECT_EQ(table.best(ShapeId{0}, k).orientation, slots[k].orientation);
  }
}

}  // namespace
}  // namespace selvage::matching
