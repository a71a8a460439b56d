// Cut files in and out.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "core/marker/validity.h"
#include "protocol/document/annotations.h"
#include "protocol/files/writing.h"
#include "protocol/formats/format.h"
#include "protocol/plots/cut_file.h"
#include "protocol/plots/route.h"
#include "tests/protocol/trade/example.h"

namespace selvage {
namespace {

using protocol::document::Spot;
using protocol::files::FileFormat;
using protocol::plots::route_through;
using test::read_example;

TEST(CutIn, LabelsGiveSizeBundleAndName) {
  const MarkerFile file = read_example("gemini_like.cut");
  ASSERT_EQ(file.marker.pieces.size(), 3U);
  EXPECT_EQ(file.marker.name, "TEE-1");
  EXPECT_EQ(file.marker.pieces[0].id, "M-A FRONT");
  EXPECT_EQ(file.attributes.pieces[2]["bundle"], "L-A");
  EXPECT_EQ(file.attributes.shapes[2]["size"], "L");
  EXPECT_EQ(to_decimal(length_of(file.marker), file.marker.resolution), 1050);
  EXPECT_EQ(to_decimal(file.marker.strip.width, file.marker.resolution), 640);
  EXPECT_TRUE(test::has_note(file, "0.1 mm, by G71"));
}

TEST(CutIn, AnOutlineOfTwoRunsIsJoinedAndInnerCutsStay) {
  const MarkerFile file = read_example("gerber_like.cut");
  ASSERT_EQ(file.marker.pieces.size(), 2U);
  EXPECT_EQ(file.marker.pieces[0].id, "FRONT 40");
  EXPECT_NEAR(to_decimal(length_of(file.marker), file.marker.resolution), 4000 * 0.254, 1e-6);
  const auto drawn = protocol::document::annotations_of(file.attributes.shapes[0]);
  ASSERT_EQ(drawn.lines.size(), 1U);
  EXPECT_EQ(drawn.lines[0].kind, protocol::document::LineKind::kCutOut);
  EXPECT_EQ(drawn.drills.size(), 1U);
}

TEST(CutIn, BlanksInWordsAndMarksOfTheTapeAreSkipped) {
  const std::string text = "%\nG71*N1*M15*X 0 Y 0*M14*X 1000 Y0*\r\nX 1000 Y 500*X0 Y500*X0Y0*M15*M0*\n%";
  const auto file = protocol::files::read_file(text);
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->marker.pieces.size(), 1U);
  EXPECT_DOUBLE_EQ(test::extent_of(*file, file->marker.shapes.front().id).x, 100);
  EXPECT_TRUE(test::has_note(*file, "by G71"));
}

TEST(CutIn, NanAndInfAreNoNumbers) {
  for (const std::string word : {"Ynan", "Yinf", "Y-inf"}) {
    const auto file = protocol::files::read_file("H1*G71*M70*M15*N1*X0Y0*M14*X1000Y0*X1000Y1000*X0Y1000*X0Y0*M15*X200" +
                                                 word + "M43*M0*");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_TRUE(protocol::document::annotations_of(file->attributes.shapes[0]).drills.empty()) << word;
  }
}

TEST(CutIn, WithoutNumbersEveryPieceHasWhatLiesInIt) {
  const std::string square = "X1000Y0*X1000Y1000*X0Y1000*X0Y0*M15*";
  const std::string other = "X2000Y0*M14*X3000Y0*X3000Y1000*X2000Y1000*X2000Y0*M15*";
  const auto file =
      protocol::files::read_file("G71*X100Y500M31*LEFT*X0Y0*M14*" + square + "M31*X2100Y500*RIGHT*" + other +
                                 "X300Y300M43*X2300Y300M43*X2500Y300M43*X2200Y200*M14*X2400Y400*M15*X9000Y0M43*M0*");
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->marker.pieces.size(), 2U);
  EXPECT_EQ(file->marker.pieces[0].id, "LEFT");
  EXPECT_EQ(file->marker.pieces[1].id, "RIGHT");
  const auto left = protocol::document::annotations_of(file->attributes.shapes[0]);
  const auto right = protocol::document::annotations_of(file->attributes.shapes[1]);
  EXPECT_EQ(left.drills.size(), 1U);
  EXPECT_EQ(left.lines.size(), 0U);
  EXPECT_EQ(right.drills.size(), 2U);
  EXPECT_EQ(right.lines.size(), 1U);
  EXPECT_TRUE(test::has_note(*file, "1 labels, drill holes and open cuts outside of all pieces"));
}

TEST(CutIn, WhatThePenDrawsIsAnInnerLine) {
  const auto file = protocol::files::read_file(
      "H1*G71*M70*D2*M15*N1*X100Y100*D1*X900Y100*D2*X0Y0*M14*X1000Y0*X1000Y500*X0Y500*X0Y0*M15*M0*");
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->marker.pieces.size(), 1U);
  EXPECT_NEAR(test::area_of(*file, 0), 100 * 50, 1e-6);
  const auto drawn = protocol::document::annotations_of(file->attributes.shapes[0]);
  ASSERT_EQ(drawn.lines.size(), 1U);
  EXPECT_EQ(drawn.lines[0].kind, protocol::document::LineKind::kInternal);
  EXPECT_NEAR(drawn.lines[0].points.back().x - drawn.lines[0].points.front().x, 80, 1e-6);
}

// With D codes in blocks of their own, and in the blocks of the coordinates.
TEST(CutIn, WithoutAKnifeThePenDrawsTheOutlines) {
  for (const char* text : {"H1*G71*M70*D2*N1*X0Y0*D1*X1000Y0*X1000Y500*X0Y500*X0Y0*D2*M0*",
                           "G71*M70*X0Y0D2*X1000Y0D1*X1000Y500D1*X0Y500D01*X0Y0D01*D02*M00*"}) {
    const auto file = protocol::files::read_file(text);
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_EQ(file->marker.pieces.size(), 1U);
    EXPECT_NEAR(test::area_of(*file, 0), 100 * 50, 1e-6);
    EXPECT_TRUE(test::has_note(*file, "nothing is cut: what the pen draws (D1)"));
  }
}

TEST(CutIn, AnOriginBehindTheFirstCutAndDrillHolesByRAreNotedAndRead) {
  const auto file =
      protocol::files::read_file("G71*M70*N1*X0Y0*M14*X1000Y0*X1000Y500*X0Y500*X0Y0*M15*X300Y300R*M70*X500Y300*R*M0*");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(protocol::document::annotations_of(file->attributes.shapes[0]).drills.size(), 2U);
  EXPECT_TRUE(test::has_note(*file, "/block/12: M70 after the first cut is ignored"));
}

TEST(CutOut, IsReadBackToATenthOfAMillimetre) {
  const MarkerFile file = read_example("polypattern_like.dxf");
  const auto text = protocol::files::write_marker(file, FileFormat::kCut);
  ASSERT_TRUE(text);
  const auto back = protocol::files::read_file(*text);
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_EQ(back->marker.pieces.size(), file.marker.pieces.size());
  EXPECT_NEAR(to_decimal(length_of(back->marker), back->marker.resolution),
              to_decimal(length_of(file.marker), file.marker.resolution), 0.051);
  double area = 0, area_back = 0;
  for (std::uint32_t k = 0; k < file.marker.pieces.size(); ++k) {
    const double unit = to_decimal(1, file.marker.resolution), unit_back = to_decimal(1, back->marker.resolution);
    area += static_cast<double>(geometry::doubled_area(placed_outline(file.marker, PieceId{k}))) * unit * unit;
    area_back +=
        static_cast<double>(geometry::doubled_area(placed_outline(back->marker, PieceId{k}))) * unit_back * unit_back;
  }
  EXPECT_NEAR(area_back / area, 1, 1e-3);
  // The outline is cut last: drill holes and notches come before it.
  EXPECT_LT(text->find("M43"), text->find("N2*"));
}

TEST(Route, VisitsEveryPieceOnceAndTravelsLessThanAsGiven) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> place{0, 3000};
  std::vector<std::vector<Spot>> outlines;
  for (int k = 0; k < 60; ++k) {
    const double x = place(random), y = place(random);
    outlines.push_back({{x, y}, {x + 80, y}, {x + 80, y + 50}, {x, y + 50}});
  }
  const auto route = route_through(outlines);
  ASSERT_EQ(route.stops.size(), outlines.size());
  std::vector<int> visits(outlines.size());
  double travel = 0;
  Spot here;
  for (const auto& stop : route.stops) {
    ++visits[stop.piece];
    const Spot next = outlines[stop.piece].at(stop.vertex);
    travel += std::hypot(next.x - here.x, next.y - here.y);
    here = next;
  }
  EXPECT_EQ(visits, std::vector<int>(outlines.size(), 1));
  EXPECT_NEAR(route.travel, travel, 1e-6);
  EXPECT_LT(route.travel, protocol::plots::travel_as_given(outlines) / 3);
}

TEST(Route, OfThreePiecesInARowIsTheShortest) {
  const auto square = [](double x) { return std::vector<Spot>{{x, 0}, {x + 10, 0}, {x + 10, 10}, {x, 10}}; };
  EXPECT_DOUBLE_EQ(route_through({square(200), square(0), square(100)}).travel, 200);
}

TEST(RealCut, GeminiIsReadWhole) {
  const std::string text = test::real_file("cutter/GEMINI.cut");
  if (text.empty()) GTEST_SKIP() << "SELVAGE_TRADE_DATA does not name the folder of real files";
  const auto file = protocol::files::read_file(text);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->marker.pieces.size(), 160U);
  EXPECT_NEAR(to_decimal(length_of(file->marker), file->marker.resolution), 9419.5, 1e-9);
  EXPECT_EQ(to_decimal(file->marker.strip.width, file->marker.resolution), 1800);
  std::set<std::string> bundles;
  for (const Json& attributes : file->attributes.pieces) bundles.insert(attributes["bundle"].get<std::string>());
  EXPECT_EQ(bundles.size(), 10U);
  EXPECT_FALSE(is_valid(file->marker));
  const auto allowed = protocol::formats::with_overlap(*file, 1.4);
  ASSERT_TRUE(allowed) << allowed.error().message;
  EXPECT_TRUE(is_valid(allowed->marker));
}

}  // namespace
}  // namespace selvage
