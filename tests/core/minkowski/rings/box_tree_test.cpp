// Tests of the box tree over a sum's edges (core/minkowski/rings/box_tree.h).
#include "core/minkowski/rings/box_tree.h"

#include <gtest/gtest.h>

#include <vector>

namespace selvage::minkowski::rings {
namespace {

std::vector<convolution::SumEdge> edges(std::size_t count) {
  std::vector<convolution::SumEdge> made(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto x = static_cast<Coord>(k);
    made[k].from = {x, x * x % 17};
    made[k].to = {x - 3, x * x % 13};
  }
  return made;
}

TEST(BoxTree, HasNoBoxesWithoutEdges) {
  EXPECT_EQ(BoxTree{}.levels(), 0U);
  EXPECT_EQ(BoxTree{edges(0)}.levels(), 0U);
}

TEST(BoxTree, EachBoxBoundsItsChildrenAndTheRootBoundsAllEdges) {
  for (std::size_t count = 1; count < 300; ++count) {
    SCOPED_TRACE(count);
    const auto below = edges(count);
    const BoxTree tree{below};
    std::size_t boxes = count;
    for (std::size_t level = 1; level <= tree.levels(); ++level) {
      const auto box_below = [&](std::size_t k) { return level == 1 ? box_of(below[k]) : tree.box(level - 1, k); };
      std::size_t next = 0;  // the first child on the level below that no box has covered yet
      std::size_t index = 0;
      for (; next < boxes; ++index) {
        ASSERT_EQ(next, index * BoxTree::kFan);
        const std::size_t end = tree.end_of_run(level - 1, index);
        ASSERT_GT(end, next);
        Box all = box_below(next);
        while (++next < end) all = united(all, box_below(next));
        EXPECT_EQ(tree.box(level, index), all);
      }
      EXPECT_EQ(next, boxes);
      boxes = index;
    }
    EXPECT_EQ(boxes, 1U);
  }
}

}  // namespace
}  // namespace selvage::minkowski::rings
