// How a long marker is divided into sections and layers.
#include "core/motion/sections/sections.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/motion/markers.h"
#include "tests/support/garment.h"
#include "tests/support/tiled/tiled_marker.h"

namespace selvage::motion::sections {
namespace {

using test::Layout;

// How often each piece is free, and how often it belongs to the layer on the right of a section.
struct Uses {
  std::vector<int> free, right;
};
Uses uses_of(const std::vector<Section>& sections, std::size_t pieces) {
  Uses uses{std::vector<int>(pieces), std::vector<int>(pieces)};
  for (const Section& section : sections) {
    for (const std::uint32_t i : section.free) ++uses.free[i];
    for (const std::uint32_t i : section.right) ++uses.right[i];
  }
  return uses;
}

class SectionsOfGarments : public ::testing::TestWithParam<const char*> {
 protected:
  const Marker marker_ = test::tiled(test::garment(GetParam()), 400);
  const marker::PlacedPieces pieces_{marker_};
  const Coord layer_ = marker_.strip.width / 10;
};
INSTANTIATE_TEST_SUITE_P(All, SectionsOfGarments, test::kGarments, test::garment_name);

TEST_P(SectionsOfGarments, EveryPieceIsFreeOnceOrLiesInOneLayer) {
  for (const double offset : {0.0, 0.4, 0.9}) {
    const auto sections = sections_of(pieces_, {60, offset, layer_});
    EXPECT_GE(sections.size(), 4U);
    const Uses uses = uses_of(sections, pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) EXPECT_EQ(uses.free[i] + uses.right[i], 1) << i;
    EXPECT_TRUE(sections.front().left.empty());
    EXPECT_TRUE(sections.back().right.empty());
    for (std::size_t s = 1; s < sections.size(); ++s) {
      EXPECT_FALSE(sections[s].free.empty());
      EXPECT_EQ(sections[s].left, sections[s - 1].right);
    }
  }
}

TEST_P(SectionsOfGarments, ALayerLiesBetweenThePiecesOfTwoSections) {
  const auto sections = sections_of(pieces_, {60, 0.5, layer_});
  for (std::size_t s = 1; s < sections.size(); ++s) {
    for (const std::uint32_t i : sections[s].free) {
      EXPECT_GE(pieces_.box(i).low.x, sections[s].from);
      for (const std::uint32_t j : sections[s - 1].free) {
        EXPECT_GE(pieces_.box(i).low.x, pieces_.box(j).high.x + layer_);
      }
    }
  }
}

TEST(Sections, AShortMarkerIsOne) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  for (int k = 0; k < 5; ++k) layout.put(square, {100 * k, 0});
  const auto sections = sections_of(marker::PlacedPieces{layout.marker()}, {20, 0, 100});
  ASSERT_EQ(sections.size(), 1U);
  EXPECT_EQ(sections[0].free, (Pieces{0, 1, 2, 3, 4}));
}

TEST(Sections, NoPieceReachesFromOneCutToTheNext) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  for (int k = 0; k < 60; ++k) layout.put(square, {100 * k, 0});
  const auto cuts = [](const Marker& marker) {
    return sections_of(marker::PlacedPieces{marker}, {10, 0, 100}).size() - 1;
  };
  EXPECT_EQ(cuts(layout.marker()), 5U);
  layout.put(layout.shape_of(test::rectangle(2500, 100)), {1500, 500});
  EXPECT_EQ(cuts(layout.marker()), 2U);
}

}  // namespace
}  // namespace selvage::motion::sections
