// Tests of searches for boxes by area (core/minkowski/rings/boxes_by_area.h), against a scan of all boxes.
#include "core/minkowski/rings/boxes_by_area.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/polygons.h"

namespace selvage::minkowski::rings {
namespace {

Box random_box(test::Random& random) {
  const Vec low{random.between(0, 100), random.between(0, 100)};
  return {low, {low.x + random.between(0, 30), low.y + random.between(0, 30)}};
}

struct Boxes {
  Boxes(test::Random& random, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) boxes.push_back(random_box(random));
    order = by_area(boxes);
    rank.resize(count);
    for (std::uint32_t place = 0; place < count; ++place) rank[order[place]] = place;
    left_out.resize(count);
  }

  std::vector<Box> boxes;
  std::vector<std::uint32_t> order, rank;
  std::vector<bool> left_out;
};

std::vector<std::uint32_t> all_found(BoxesByArea& search) {
  std::vector<std::uint32_t> found;
  while (const auto one = search.next()) found.push_back(*one);
  return found;
}

TEST(BoxesByArea, AreOrderedByArea) {
  const std::vector<Box> boxes{{{0, 0}, {1, 1}}, {{0, 0}, {9, 1}}, {{5, 5}, {8, 8}}, {{0, 0}, {3, 3}}};
  EXPECT_EQ(by_area(boxes), (std::vector<std::uint32_t>{1, 2, 3, 0}));  // the two of 9 by their indices
}

TEST(BoxesByArea, FindsWhatAScanFinds) {
  test::Random random{41};
  for (std::size_t count = 0; count < 200; ++count) {
    SCOPED_TRACE(count);
    Boxes all{random, count};
    BoxesByArea search{all.boxes, all.rank};
    for (int trial = 0; trial < 10; ++trial) {
      const Box window = random_box(random);
      std::vector<std::uint32_t> touching;
      std::vector<std::uint32_t> containing;
      for (const std::uint32_t k : all.order) {
        if (!all.left_out[k] && all.boxes[k].touches(window)) touching.push_back(k);
        if (!all.left_out[k] && all.boxes[k].contains(window)) containing.insert(containing.begin(), k);
      }
      search.search_touching(window);
      EXPECT_EQ(all_found(search), touching);
      search.search_containing(window);
      EXPECT_EQ(all_found(search), containing);
      if (count == 0) continue;
      const auto gone = static_cast<std::uint32_t>(random.between(0, static_cast<Coord>(count) - 1));
      search.leave_out(gone);
      all.left_out[gone] = true;
    }
  }
}

}  // namespace
}  // namespace selvage::minkowski::rings
