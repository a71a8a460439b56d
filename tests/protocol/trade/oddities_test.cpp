// Oddities of pattern files that would stop a reader or mislead it: line ends, scaled and mirrored INSERTs, names in
// the blocks alone, formatted texts, and outlines that cross themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "protocol/document/annotations.h"
#include "tests/protocol/trade/example.h"
#include "tests/protocol/trade/pattern_text.h"

namespace selvage {
namespace {

using protocol::files::read_file;
using test::area_of;
using test::Corners;
using test::extent_of;
using test::file_inserting;
using test::file_of;
using test::has_note;
using test::insert;
using test::named;
using test::polyline;
using test::read_text;
using test::tag;
using test::text;

const std::string kUnits = text("Units: METRIC");
constexpr double kArea = 300 * 200 + 300 * 60 / 2.0;  // of the outline

std::string with_line_ends(const std::string& file, const std::string& end) {
  std::string out;
  for (const char c : file) out += c == '\n' ? end : std::string{c};
  return out;
}

TEST(LineEnds, OfThreeCharactersCountOnce) {
  EXPECT_NEAR(area_of(read_text(with_line_ends(file_of(named("A")), "\r\r\n")), 0), kArea, 1e-6);
}

TEST(LineEnds, BlankLinesAroundTheFileAreSkipped) {
  const std::string file = file_of(named("A"));
  const std::string without_end = file.substr(0, file.rfind("0\nEOF"));
  EXPECT_NEAR(area_of(read_text("\n\n" + without_end + "\n\n\n"), 0), kArea, 1e-6);
  EXPECT_FALSE(read_file(without_end + "\n\n\n0\nLINE\n")) << "blank lines between groups hide an error";
}

TEST(Texts, OfSeveralParagraphsAreReadWithoutTheirFormat) {
  const std::string formatted = text(
      "{\\fArial|b0|i0;Piece Name: A}\\P\\H2.5;Quantity: 1,1\\PUnits: \\LMETRIC\\l\\PCare \\{wool\\}", 0, 0, "MTEXT");
  const MarkerFile file = read_text(file_of(formatted + polyline(test::kOutline, true), ""));
  EXPECT_EQ(file.marker.pieces.size(), 2U);
  EXPECT_EQ(file.marker.shapes.front().id, "A");
  const auto drawn = protocol::document::annotations_of(file.attributes.shapes.front());
  ASSERT_EQ(drawn.texts.size(), 1U);
  EXPECT_EQ(drawn.texts.front().text, "Care {wool}");
}

TEST(Texts, ANameOfABlockAloneDecidesTheEncoding) {
  const std::string front = "\xc7\xb0\xc6\xac\xb4\xf3\xc9\xed";  // of a whole front piece, in GBK
  const MarkerFile file = read_text(file_inserting(kUnits, polyline(test::kOutline, true), "", front));
  EXPECT_EQ(file.marker.shapes.front().id, "前片大身");
}

TEST(Inserts, ThatScaleABlockScaleItsPiece) {
  const std::string scaled = tag(41, "2.54") + tag(42, "-2.54");
  const MarkerFile file = read_text(file_inserting(insert(scaled) + kUnits, named("A")));
  EXPECT_NEAR(extent_of(file, "A").x, 762, 1e-6);
  EXPECT_TRUE(has_note(file, "is inserted at the scale 2.54, which is applied"));
  const MarkerFile uneven = read_text(file_inserting(insert(tag(41, "2")) + kUnits, named("A")));
  EXPECT_NEAR(extent_of(uneven, "A").x, 300, 1e-6);
  EXPECT_TRUE(has_note(uneven, "read as drawn"));
}

// The peak of the outline lies to the left, at x = 120 of 300.
TEST(Inserts, ThatMirrorABlockMirrorItsPiece) {
  const MarkerFile file = read_text(file_inserting(insert(tag(41, "-1")) + kUnits, named("A")));
  const MarkerFile drawn = read_text(file_inserting(insert() + kUnits, named("A")));
  const auto peak = [](const MarkerFile& of) {
    const Polygon& outline = of.marker.shapes.front().outline;
    return std::count_if(outline.begin(), outline.end(), [](Vec v) { return v.y == 0; });
  };
  EXPECT_EQ(peak(drawn), 2) << "an edge lies below";
  EXPECT_EQ(peak(file), 1) << "the peak lies below";
  EXPECT_NEAR(area_of(file, 0), kArea, 1e-6);
  EXPECT_TRUE(has_note(file, "is inserted mirrored"));
}

TEST(Inserts, AsDrawnAndMirroredAreAPairUnlessTheQuantitySaysOtherwise) {
  const std::string both = insert() + insert(tag(41, "-1")) + kUnits;
  const MarkerFile file = read_text(file_inserting(both, named("A")));
  ASSERT_EQ(file.marker.pieces.size(), 2U);
  EXPECT_NE(file.marker.pieces[0].orientation.flip, file.marker.pieces[1].orientation.flip);
  EXPECT_EQ(read_text(file_inserting(both, named("A") + text("Quantity: 1"))).marker.pieces.size(), 1U);
}

TEST(Crossings, OfASmallLoopAreRemoved) {
  const Corners corner{{0, 0}, {300, 0}, {300, 200.5}, {300.5, 200}, {0, 200}};  // a step back over the corner
  const MarkerFile file = read_text(file_of(named("A", polyline(corner, true))));
  EXPECT_NEAR(area_of(file, 0), 300 * 200, 1);
  EXPECT_TRUE(has_note(file, "piece \"A\": its outline crosses or touches itself"));
}

TEST(Crossings, OfALargeLoopAreRefusedWithThePiecesName) {
  const auto file = read_file(file_of(named("A", polyline({{0, 0}, {300, 0}, {0, 200}, {300, 200}}, true))));
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("piece \"A\": the outline must not cross"), std::string::npos)
      << file.error().message;
}

TEST(RuleTables, MayPutTheirNumbersInBracketsAndTheirSizesInQuotes) {
  protocol::trade::ReadingOptions options;
  for (const char* numbers : {"(0,0) (40,20)", "0;0;40;20", "0\t0\t40\t20"}) {
    options.rules =
        std::string{"UNITS: METRIC\nSIZE LIST: \"S\" \"M\"\nSAMPLE SIZE: S\nRULE: DELTA 2\n0 0 0 0\nRULE: DELTA 1\n"} +
        numbers + "\nEND\n";
    const MarkerFile file = read_text(file_of(named("A") + text("# 1", 300, 200) + text("# 2")), options);
    EXPECT_NEAR(extent_of(file, "A/M").x, 340, 1e-6) << numbers;
  }
}

TEST(UnknownFiles, AreSaidToBeOfNoKnownKind) {
  const auto file = read_file("solid part\n");
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("DXF, SVG, ESICUP XML, cut or HPGL"), std::string::npos) << file.error().message;
}

}  // namespace
}  // namespace selvage
