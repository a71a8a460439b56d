#include "protocol/library/labels.h"

#include <gtest/gtest.h>

#include "protocol/formats/format.h"

namespace selvage::protocol::library {
namespace {

using matching::Label;

TEST(Labels, LeaveNamesWithoutTheSizeAsTheyAre) {
  EXPECT_EQ(label_from("back", "36"), (Label{"back", "36"}));
  EXPECT_EQ(label_from("", "36"), (Label{"", "36"}));
  EXPECT_EQ(label_from("jeans.back_36_L", "38"), (Label{"jeans.back_36_L", "38"}));
  EXPECT_EQ(label_from("back_136", "36"), (Label{"back_136", "36"}));
  EXPECT_EQ(label_from("36 back 36", "36"), (Label{"36 back 36", "36"}));  // either may be the size
}

TEST(Labels, TakeTheSizeOutOfTheName) {
  EXPECT_EQ(label_from("jeans.back_36_L", "36"), (Label{"jeans.back__L", "36"}));
  EXPECT_EQ(label_from("back-XL", "XL"), (Label{"back-", "XL"}));
  EXPECT_EQ(label_from("\xC3\xA9paule 44", "44"), (Label{"\xC3\xA9paule ", "44"}));
}

TEST(Labels, TakeNoNumberForTheSize) {
  EXPECT_EQ(label_from("back", ""), (Label{"back", ""}));
  EXPECT_EQ(label_from("pocket 2", ""), (Label{"pocket 2", ""}));
}

TEST(Labels, AreThoseOfThePieceOrOfItsShape) {
  const auto file = formats::read_marker(R"({"format": "selvage-marker", "version": 1, "strip": {"width": 80},
    "shapes": [{"id": "s", "outline": [[0, 0], [20, 0], [20, 20]], "attributes": {"name": "back 36", "size": 36}},
               {"id": "t", "outline": [[0, 0], [20, 0], [20, 20]], "attributes": {"name": 7.5}}],
    "pieces": [{"id": "a", "shape": "s", "at": [0, 0]}, {"id": "b", "shape": "s", "at": [40, 0], "attributes": {"name": "yoke", "size": "M"}}],
    "unplaced": [{"id": "c", "shape": "t"}, {"id": "d", "shape": "s", "attributes": {"size": "38"}}]})");
  ASSERT_TRUE(file) << file.error().message;
  const matching::LabelledMarker marker = labelled(*file);
  EXPECT_EQ(marker.marker, file->marker);
  EXPECT_EQ(marker.labels, (std::vector<Label>{{"back ", "36"}, {"yoke", "M"}, {"", ""}, {"back 36", "38"}}));
}

}  // namespace
}  // namespace selvage::protocol::library
