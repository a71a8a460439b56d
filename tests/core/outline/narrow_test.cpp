#include "core/outline/narrow.h"

#include <gtest/gtest.h>

namespace selvage::outline {
namespace {

TEST(NarrowPart, IsAStrapThinnerThanTheWidth) {
  const Polygon strapped{{0, 0}, {100, 0}, {100, 40}, {200, 40}, {200, 44}, {100, 44}, {100, 100}, {0, 100}};
  EXPECT_TRUE(narrow_part(strapped, 5));
  EXPECT_FALSE(narrow_part(strapped, 4));
}

TEST(NarrowPart, IsANeckBetweenTwoWideParts) {
  const Polygon waisted{{0, 0}, {50, 30}, {100, 0}, {100, 66}, {50, 36}, {0, 66}};
  EXPECT_FALSE(narrow_part(waisted, 6));  // the edges beside the neck widen at once
  const Polygon necked{{0, 0}, {40, 30}, {60, 30}, {100, 0}, {100, 66}, {60, 36}, {40, 36}, {0, 66}};
  EXPECT_TRUE(narrow_part(necked, 7));
}

TEST(NarrowPart, IsNeitherAnAcuteCornerNorASlot) {
  EXPECT_FALSE(narrow_part({{0, 0}, {300, 0}, {300, 20}}, 10));
  const Polygon slotted{{0, 0}, {100, 0}, {100, 100}, {52, 100}, {52, 20}, {48, 20}, {48, 100}, {0, 100}};
  EXPECT_FALSE(narrow_part(slotted, 10));  // cloth lies on the other side of the edges
}

}  // namespace
}  // namespace selvage::outline
