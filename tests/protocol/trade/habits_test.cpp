// Habits of pattern files beyond those of the examples: texts of units and quantities, encodings of names, outlines
// with gaps.  The files are written here, each with one piece of five corners and one oddity.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "protocol/document/annotations.h"
#include "protocol/trade/text.h"
#include "tests/protocol/trade/example.h"
#include "tests/protocol/trade/pattern_text.h"

namespace selvage {
namespace {

using protocol::files::read_file;
using protocol::trade::ReadingOptions;
using test::Corners;
using test::extent_of;
using test::file_of;
using test::has_note;
using test::kOutline;
using test::named;
using test::pieces_of;
using test::polyline;
using test::read_text;
using test::spot;
using test::tag;
using test::text;

TEST(UnitText, IsKnownInItsSpellings) {
  for (const auto& [said, millimetres] : {std::pair{"Units: MILLIMETERS", 300.0},
                                          {"UNITS: Metric (mm)", 300.0},
                                          {"UNIT: centimetres", 3000.0},
                                          {"Units: Inches", 7620.0},
                                          {"Units = FEET", 91440.0},
                                          {"Units: YARDS", 274320.0}}) {
    EXPECT_NEAR(extent_of(read_text(file_of(named("A"), text(said))), "A").x, millimetres, 1e-6) << said;
  }
}

TEST(UnitText, MayStandInTheBlock) {
  EXPECT_NEAR(extent_of(read_text(file_of(named("A") + text("Units: METRIC"), "")), "A").x, 300, 1e-6);
}

TEST(UnitText, AnUnknownOneIsNamed) {
  const auto file = read_file(file_of(named("A"), text("Units: FURLONG")));
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().field, "/unit");
  EXPECT_NE(file.error().message.find("FURLONG"), std::string::npos) << file.error().message;
}

TEST(QuantityText, IsKnownInItsSpellings) {
  struct Case {
    const char* said;
    std::size_t right, left;
  };
  for (const Case& one : {Case{"L1 R1", 1, 1},
                          {"R2", 2, 0},
                          {"L=2 R=1", 1, 2},
                          {"PAIR", 1, 1},
                          {"2 pairs", 2, 2},
                          {"1;1", 1, 1},
                          {"1/2", 1, 2},
                          {"2.0", 2, 0},
                          {"x2", 2, 0},
                          {"3 pcs", 3, 0},
                          {"Cut 2", 2, 0},
                          {"cut 1 on fold", 1, 0},
                          {"QTY 1,1", 1, 1},
                          {"Cut 1 pair", 1, 1},
                          {"2 prs", 2, 2},
                          {"2 (1+1)", 1, 1},
                          {"2", 2, 0}}) {
    const MarkerFile file = read_text(file_of(named("A") + text(std::string{"Quantity: "} + one.said)));
    std::size_t flipped = 0;
    for (const Piece& piece : file.marker.pieces) flipped += piece.orientation.flip ? 1 : 0;
    EXPECT_EQ(file.marker.pieces.size(), one.right + one.left) << one.said;
    EXPECT_EQ(flipped, one.left) << one.said;
  }
}

TEST(QuantityText, MayStandInATextOfAnotherForm) {
  for (const char* said : {"QTY 1,1", "QTY: 1,1", "Quantity = 1,1", "CUT 1 PAIR"}) {
    EXPECT_EQ(read_text(file_of(named("A") + text(said))).marker.pieces.size(), 2U) << said;
  }
  EXPECT_EQ(read_text(file_of(named("A") + text("CUT HERE"))).marker.pieces.size(), 1U);
}

TEST(QuantityText, WhatIsNotUnderstoodIsOneWithANote) {
  for (const char* said : {"-1", "many", "1.5", "L1 L2", "10001"}) {
    const MarkerFile file = read_text(file_of(named("A") + text(std::string{"Quantity: "} + said)));
    EXPECT_EQ(file.marker.pieces.size(), 1U) << said;
    EXPECT_TRUE(has_note(file, "is not understood: 1")) << said;
  }
}

TEST(Encodings, AccentedLettersAreNotTakenForChineseCharacters) {
  using protocol::trade::Encoding;
  using protocol::trade::encoding_of;
  for (const char* name : {"Pi\xe9"
                           "ce",
                           "Gr\xf6\xdf"
                           "e R\xdc"
                           "CKEN",
                           "\xc4RMEL", "ESPALDA DISE\xd1O",
                           "FA\xc7"
                           "ADE CORS\xc9"}) {
    EXPECT_EQ(encoding_of(name), Encoding::kWestern) << name;
  }
  EXPECT_EQ(encoding_of("\xc7\xb0\xc6\xac"), Encoding::kGbk);                           // front piece
  EXPECT_EQ(encoding_of("A\xbf\xee\xc7\xb0\xc6\xacL"), Encoding::kGbk);                 // between letters
  EXPECT_EQ(encoding_of("\xab\xe1\xa4\xf9\xbb\xe2"), Encoding::kBig5);                  // back piece, collar
  EXPECT_EQ(encoding_of("\xab\x65\xa4\xf9\xa5\xaa"), Encoding::kBig5);                  // front piece, left
  EXPECT_EQ(encoding_of("\xd0\x9f\xd0\xb5\xd1\x80\xd0\xb5\xd0\xb4"), Encoding::kUtf8);  // Cyrillic
  EXPECT_EQ(encoding_of("Man\xc8\x99on \xc3\xa9"), Encoding::kUtf8);
  EXPECT_EQ(encoding_of("FRONT"), Encoding::kUtf8);
  EXPECT_EQ(encoding_of("\xa5\x6b", "ANSI_950"), Encoding::kBig5);
  EXPECT_EQ(encoding_of("Gr\xf6\xdf"
                        "e",
                        "ANSI_1252"),
            Encoding::kWestern);
}

TEST(Encodings, TheStatedCodePageCounts) {
  const std::string header = tag(9, "$DWGCODEPAGE") + tag(3, "ANSI_1251");
  const MarkerFile file = read_text(file_of(named("\xcf\xe5\xf0\xe5\xe4"), text("Units: METRIC"), header));
  EXPECT_EQ(file.marker.shapes.front().id, "Перед");
  EXPECT_TRUE(has_note(file, "texts are read as Windows-1251"));
}

TEST(Gaps, OfAMillimetreAreClosedBetweenAnyRuns) {
  const std::string runs = polyline({{0, 0}, {300, 0}}, false) + polyline({{119.5, 260}, {0, 200}, {0, 0.4}}, false) +
                           polyline({{120, 260}, {300, 200}, {300, 0.6}}, false);
  const MarkerFile file = read_text(file_of(named("A", runs)));
  EXPECT_NEAR(extent_of(file, "A").x, 300, 1e-6);
  EXPECT_NEAR(extent_of(file, "A").y, 260, 1e-6);
  EXPECT_EQ(file.marker.shapes.front().outline.size(), 6U) << "both ends of a gap remain, but for those on an edge";
  EXPECT_TRUE(has_note(file, "the boundary is open by 0.6 mm; closed"));
}

TEST(Gaps, AClosedLineInAnOutlineWithAGapIsNotThePiece) {
  const std::string small = polyline({{50, 50}, {60, 50}, {60, 60}, {50, 60}}, true);
  Corners open = kOutline;
  open.emplace_back(0, 0.5);
  EXPECT_NEAR(extent_of(read_text(file_of(named("A", small + polyline(open, false)))), "A").x, 300, 1e-6);
  open.back() = {0, 50};
  const auto wide = read_file(file_of(named("A", small + polyline(open, false))));
  ASSERT_FALSE(wide);
  EXPECT_NE(wide.error().message.find("its ends are 50 mm apart"), std::string::npos) << wide.error().message;
}

TEST(Gaps, VerticesThatRoundingHasMovedPastEachOtherAreOne) {
  Corners twice;
  for (const auto& [x, y] : kOutline) twice.insert(twice.end(), {{x, y}, {x + 0.001, y}});
  const MarkerFile file = read_text(file_of(named("A", polyline(twice, true))));
  EXPECT_EQ(file.marker.shapes.front().outline.size(), 5U);
  EXPECT_TRUE(has_note(file, "5 vertices within 0.01 mm of the one before left out"));
}

TEST(Inserts, ABlockThatIsInsertedTwiceIsNoted) {
  const std::string again = tag(0, "INSERT") + tag(2, "B") + spot(500, 0);
  const MarkerFile file = read_text(file_of(named("A"), again + text("Units: METRIC")));
  EXPECT_EQ(pieces_of(file, "A"), 1U);
  EXPECT_TRUE(has_note(file, "inserted 2 times; its quantity counts"));
}

TEST(Boundary, ASplineWithoutPointsIsNoted) {
  const std::string spline = tag(0, "SPLINE") + tag(8, "1") + tag(71, "3");
  EXPECT_TRUE(has_note(read_text(file_of(named("A") + spline)), "SPLINE on layer 1 is not read"));
}

// A closed spline through points of a circle: the outline contains them, and the curve hardly differs from the circle.
TEST(Boundary, ASplineOfFitPointsAloneIsTheCubicOneThroughThem) {
  constexpr int kPoints = 12;
  constexpr double kRadius = 100;
  std::string fit = tag(0, "SPLINE") + tag(8, "1") + tag(70, "1") + tag(71, "3") + tag(74, std::to_string(kPoints));
  for (int k = 0; k < kPoints; ++k) {
    const double angle = 2 * std::numbers::pi * k / kPoints;
    fit += spot(kRadius * std::cos(angle), kRadius * std::sin(angle), 11);
  }
  const MarkerFile file = read_text(file_of(named("A", fit)));
  EXPECT_NEAR(test::area_of(file, 0), std::numbers::pi * kRadius * kRadius, 0.2 * 2 * std::numbers::pi * kRadius);
  EXPECT_GE(extent_of(file, "A").x, 2 * kRadius - 1e-6);
  EXPECT_GE(extent_of(file, "A").y, 2 * kRadius - 1e-6);
  EXPECT_TRUE(has_note(file, "SPLINE has fit points only"));
  EXPECT_FALSE(has_note(file, "is not read"));
}

TEST(Boundary, AFitPointThatIsNoNumberIsRefusedWithItsLine) {
  const std::string spline = tag(0, "SPLINE") + tag(8, "1") + spot(0, 0, 11) + tag(11, "nan") + tag(21, "1");
  const auto file = read_file(file_of(named("A", spline)));
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kSyntax);
  EXPECT_TRUE(file.error().field.starts_with("/line/")) << file.error().field;
}

// Ends as the tangents say, and natural ones: from (0, 0) over (100, 50) to (200, 0), closed by a line below.
TEST(Boundary, TheEndTangentsOfASplineOfFitPointsCount) {
  const std::string points = spot(0, 0, 11) + spot(100, 50, 11) + spot(200, 0, 11);
  const std::string below = polyline({{200, 0}, {200, -100}, {0, -100}, {0, 0}}, false);
  const std::string spline = tag(0, "SPLINE") + tag(8, "1") + tag(71, "3");
  const double natural = test::area_of(read_text(file_of(named("A", spline + points + below))), 0);
  const double steep =
      test::area_of(read_text(file_of(named("A", spline + points + spot(0, 1, 12) + spot(0, -1, 13) + below))), 0);
  EXPECT_GT(natural, 200 * 100 + 200 * 50 / 2.0);
  EXPECT_LT(natural, 200 * 100 + 200 * 50);
  EXPECT_GT(steep, natural + 500);
}

// A side from (0, 0) to (300, 100) whose upper end moves: a notch in its middle moves half as far.
TEST(Grading, ANotchBetweenTwoVerticesStaysOnItsEdge) {
  const std::string notch = tag(0, "POINT") + tag(8, "4") + spot(150, 50) + tag(30, "5");
  const std::string block = named("A", polyline({{0, 0}, {300, 100}, {300, 300}, {0, 200}}, true)) + notch +
                            text("# 1", 0, 0) + text("# 2", 300, 100) + text("# 2", 300, 300) + text("# 1", 0, 200);
  ReadingOptions options;
  options.rules =
      "; a comment\r\nUNITS: METRIC\r\nSIZE LIST: S M\r\nSAMPLE SIZE: S\r\n* another\r\nRULE: DELTA 1\r\n0,0 0,0\r\n"
      "# a third\r\nRULE: DELTA 2\r\n0,0 40,20\r\nEND\r\n";
  const MarkerFile file = read_text(file_of(block + text("Size: S")), options);
  for (std::size_t k = 0; k < file.marker.shapes.size(); ++k) {
    const auto notches = protocol::document::annotations_of(file.attributes.shapes[k]).notches;
    ASSERT_EQ(notches.size(), 1U);
    const bool medium = file.marker.shapes[k].id == "A/M";
    EXPECT_NEAR(notches.front().at.x, medium ? 170 : 150, 1e-6);
    EXPECT_NEAR(notches.front().at.y, medium ? 60 : 50, 1e-6);
  }
}

}  // namespace
}  // namespace selvage
