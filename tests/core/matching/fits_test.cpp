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

}  // namespace
}  // namespace selvage::matching
