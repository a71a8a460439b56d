// Tests of core/nesting/layout/placed_boxes.h: whoever may meet a piece is found near it.
#include "core/nesting/layout/placed_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/core/nesting/unplaced_pieces.h"

namespace selvage::nesting::layout {
namespace {

using test::Random;

TEST(PlacedBoxes, FindAllThatMayMeetAndFewOthers) {
  Random random{1};
  std::size_t found = 0, met = 0;
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Polygon> outlines;
    for (int k = 0; k < 4; ++k) outlines.push_back(test::random_polygon(random, 2 * test::kSide));
    const Marker marker = test::unplaced_pieces(outlines, 30, test::kWidth);
    SumCache sums;
    const PieceSet set = *piece_set_of(marker, PlacedPiecesMay::kMove, sums);
    Layout layout{.places = {}, .length = 3'000};
    for (std::size_t piece = 0; piece < set.size(); ++piece) {
      layout.places.push_back({static_cast<double>(random.below(3'000)), static_cast<double>(random.below(1'000)),
                               static_cast<std::uint32_t>(random.below(4))});
    }
    PlacedBoxes boxes{set};
    boxes.take(layout);
    const double apart = static_cast<double>(random.below(50));
    const Place& at = layout.places[0];
    std::vector<std::uint32_t> near{7, 7, 7};
    boxes.find_near(placed_box(set, layout, 0), set.widest + apart, near);
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    for (std::uint32_t piece = 1; piece < set.size(); ++piece) {
      const Place& there = layout.places[piece];
      const bool meets =
          may_meet(set, set.kind(0).turned[at.turn], at, set.kind(piece).turned[there.turn], there, apart);
      EXPECT_TRUE(!meets || std::count(near.begin(), near.end(), piece) == 1) << "trial " << trial;
      met += meets ? 1 : 0;
    }
    found += near.size() - 1;  // without the piece itself
  }
  EXPECT_GT(met, 50);
  EXPECT_EQ(found, met);
}

}  // namespace
}  // namespace selvage::nesting::layout
