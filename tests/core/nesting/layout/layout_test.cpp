// Tests of core/nesting/layout/layout.h that need no set of pieces.
#include "core/nesting/layout/layout.h"

#include <gtest/gtest.h>

namespace selvage::nesting::layout {
namespace {

TEST(SamePlaces, AreAsNearAsTheyShouldBeInEveryOrientation) {
  const Layout layout{{{0, 0, 0}, {10, 5, 1}}, 20};
  Layout other = layout;
  EXPECT_TRUE(same_places(layout, other, 0));
  other.places[1].x += 3;
  other.places[1].y += 4;
  other.length = 30;
  EXPECT_TRUE(same_places(layout, other, 5));
  EXPECT_FALSE(same_places(layout, other, 4.99));
  other.places[0].turn = 1;
  EXPECT_FALSE(same_places(layout, other, 5));
}

}  // namespace
}  // namespace selvage::nesting::layout
