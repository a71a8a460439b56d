#include "core/packing/cores/refutation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/packing/contain.h"
#include "tests/core/motion/markers.h"

namespace selvage::packing::cores {
namespace {

// Seven cuffs of as many sizes, which may be turned by 180 degrees, and a box that is too narrow for two of them side
// by side.
class PileOfCuffs : public testing::Test {
 protected:
  PileOfCuffs() {
    test::Layout layout{100'000};
    for (Coord k = 0; k < 7; ++k) {
      const Coord width = 30'000 + 50 * k;
      const auto cuff = layout.shape_of({{0, 0}, {width, 0}, {width, 9'000}, {width - 1'000, 10'000}, {0, 10'000}});
      layout.put(cuff, {0, 12'000 * k});
    }
    marker_ = layout.marker();
    for (Shape& shape : marker_.shapes) shape.rotations = {Angle{}, Angle::of_degrees(180)};
  }

  // Whether it is refuted that the cuffs fit into a box of this height.
  bool refuted(Coord height, branching::Work& own) {
    const bodies::Freedom freedom{std::vector<bool>(7, true), Box{{0, 0}, {40'000, height}}, true};
    SumCache sums;
    Refutation refutation{marker_, freedom, ContainSettings{}.tuning, scene::Run{sums},
                          [&](const std::vector<RealVec>& positions) {
                            layouts_.push_back(positions);
                            return false;
                          }};
    branching::Work searched;
    for (searched.nodes = 0; searched.nodes < 4'000; searched.nodes += 100) {
      if (refutation.next(searched, own)) return true;
    }
    return false;
  }

  Marker marker_;
  std::vector<std::vector<RealVec>> layouts_;  // of cores
};

TEST_F(PileOfCuffs, IsRefutedWhereItIsTooHigh) {
  branching::Work own;
  EXPECT_TRUE(refuted(69'000, own));
  EXPECT_LT(own.nodes, 100);
  EXPECT_TRUE(layouts_.empty());
}

TEST_F(PileOfCuffs, IsNotRefutedWhereItFits) {
  branching::Work own;
  EXPECT_FALSE(refuted(70'000, own));
  EXPECT_GT(own.nodes, 0);
  EXPECT_LE(own.nodes, 600);
}

TEST_F(PileOfCuffs, TellsTheLayoutsOfItsCores) {
  branching::Work own;
  EXPECT_FALSE(refuted(70'000, own));
  ASSERT_FALSE(layouts_.empty());
  for (const auto& positions : layouts_) {
    ASSERT_EQ(positions.size(), 7);
    for (std::size_t a = 0; a < 7; ++a) {
      for (std::size_t b = 0; b < a; ++b) EXPECT_GE(std::abs(positions[a].y - positions[b].y), 9'900);
    }
  }
}

TEST_F(PileOfCuffs, ShortSearchesHaveNone) {
  const bodies::Freedom freedom{std::vector<bool>(7, true), Box{{0, 0}, {40'000, 60'000}}, true};
  SumCache sums;
  Refutation refutation{marker_, freedom, ContainSettings{}.tuning, scene::Run{sums},
                        [](const std::vector<RealVec>&) { return false; }};
  branching::Work searched;
  searched.nodes = 300;
  branching::Work own;
  EXPECT_FALSE(refutation.next(searched, own));
  EXPECT_EQ(own.nodes, 0);
}

}  // namespace
}  // namespace selvage::packing::cores
