// SVG, plain DXF and ESICUP in: curves, transforms, units.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/marker/validity.h"
#include "protocol/document/annotations.h"
#include "protocol/files/writing.h"
#include "tests/protocol/trade/example.h"

namespace selvage {
namespace {

using protocol::files::read_file;
using protocol::trade::ReadingOptions;
using test::area_of;
using test::extent_of;
using test::read_text;

std::string svg(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1000mm\" height=\"800mm\" viewBox=\"0 0 1000 800\">" +
         content + "</svg>";
}

// Of the area.
std::pair<double, double> centre_of(const Polygon& outline, double unit) {
  double area = 0, x = 0, y = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec a = outline[k], b = outline[(k + 1) % outline.size()];
    const double ax = unit * static_cast<double>(a.x), ay = unit * static_cast<double>(a.y);
    const double bx = unit * static_cast<double>(b.x), by = unit * static_cast<double>(b.y);
    area += ax * by - ay * bx;
    x += (ax + bx) * (ax * by - ay * bx);
    y += (ay + by) * (ax * by - ay * bx);
  }
  return {x / (3 * area), y / (3 * area)};
}

TEST(SvgIn, HiddenElementsAreNoPieces) {
  const std::string square = " d=\"M0 0H100V100H0z\"/>";
  const MarkerFile file =
      read_text(svg("<style>.a, .b {visibility: hidden} path.c { display : none }</style><path class=\"a\"" + square +
                    "<path class=\"x b\"" + square + "<path class=\"c\"" + square + "<path visibility=\"hidden\"" +
                    square + "<path style=\"visibility: hidden\"" + square + "<path d=\"M200 0H400V100H200z\"/>"));
  ASSERT_EQ(file.marker.pieces.size(), 1U);
  EXPECT_NEAR(area_of(file, 0), 200 * 100, 1e-6);
}

TEST(SvgIn, TheDrawingOfAMarkerIsRefused) {
  const MarkerFile file = test::read_example("polypattern_like.dxf");
  const auto drawing = protocol::files::write_marker(file, protocol::files::FileFormat::kSvg);
  ASSERT_TRUE(drawing);
  const auto back = read_file(*drawing);
  ASSERT_FALSE(back);
  EXPECT_NE(back.error().message.find("not to scale"), std::string::npos) << back.error().message;
}

TEST(EsicupOut, ListsUnplacedPieces) {
  const MarkerFile file = read_text(
      R"({"format": "selvage-marker", "version": 1, "strip": {"width": 100},
          "shapes": [{"id": "a", "outline": [[0, 0], [50, 0], [50, 30]], "rotations": [90, 0]}],
          "pieces": [{"id": "1", "shape": "a", "at": [0, 0]}], "unplaced": [{"id": "2", "shape": "a"}, {"id": "3", "shape": "a"}]})");
  const auto text = protocol::files::write_marker(file, protocol::files::FileFormat::kEsicup);
  ASSERT_TRUE(text);
  const MarkerFile back = read_text(*text);
  EXPECT_EQ(back.marker.pieces.size(), 1U);
  ASSERT_EQ(back.marker.unplaced.size(), 2U);
  EXPECT_EQ(back.marker.unplaced[0].orientation.rotation.degrees, 90);
}

TEST(SvgIn, LinesOfSeveralElementsFormAnOutline) {
  const MarkerFile file =
      read_text(svg("<line x1=\"0\" y1=\"0\" x2=\"300\" y2=\"0\"/><line x1=\"300\" y1=\"200\" x2=\"300\" y2=\"0\"/>"
                    "<polyline points=\"300,200 0,200 0,0\"/>"));
  ASSERT_EQ(file.marker.pieces.size(), 1U);
  EXPECT_NEAR(area_of(file, 0), 300 * 200, 1e-6);
}

TEST(SvgIn, AFillAndItsStrokeAreOnePiece) {
  const MarkerFile file =
      read_text(svg("<path fill=\"#ccc\" d=\"M0 0H300V200H0z\"/><path stroke=\"black\" d=\"M300 "
                    "200H0V0H300z\"/>"));
  EXPECT_EQ(file.marker.pieces.size(), 1U);
  EXPECT_TRUE(test::has_note(file, "its outline is drawn again; read once"));
}

// The outline holds the true circle, and lies within the tolerance of it.
TEST(Flattening, HoldsTheTrueCurve) {
  for (const double tolerance : {1.0, 0.1, 0.01}) {
    ReadingOptions options;
    options.tolerance = tolerance;
    const MarkerFile file = read_text(svg("<circle id=\"c\" cx=\"200\" cy=\"200\" r=\"100\"/>"), options);
    const double unit = to_decimal(1, file.marker.resolution);
    const Polygon& outline = file.marker.shapes[0].outline;
    const auto [x, y] = centre_of(outline, unit);
    double nearest = 1e9, farthest = 0;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vec a = outline[k], b = outline[(k + 1) % outline.size()];
      const double ax = unit * static_cast<double>(a.x) - x, ay = unit * static_cast<double>(a.y) - y;
      const double bx = unit * static_cast<double>(b.x) - x, by = unit * static_cast<double>(b.y) - y;
      nearest = std::min(nearest, std::abs(ax * by - ay * bx) / std::hypot(bx - ax, by - ay));
      farthest = std::max(farthest, std::hypot(ax, ay));
    }
    EXPECT_GE(nearest, 100 - 1e-5);
    EXPECT_LE(farthest, 100 + 1.05 * tolerance);
  }
}

// A bay is flattened by chords, so that the outline is never inside the true one either.
TEST(Flattening, OfABayStaysOutOfTheCloth) {
  const MarkerFile file = read_text(svg("<path d=\"M0 0 H300 V200 H200 A50 50 0 0 0 100 200 H0 Z\"/>"));
  const double exact = 300 * 200 - 3.14159265358979 * 50 * 50 / 2;
  EXPECT_GE(area_of(file, 0), exact);
  EXPECT_LE(area_of(file, 0), exact + 0.05 * 160);
}

// Sixty circles or curves with a size of 40 km would take a quarter of a million chords.
TEST(Flattening, NeedsNoMoreChordsThanAFileOfItsSizeMayHave) {
  std::string plot = "IN;SP1;", circles, curves, entities;
  for (int k = 0; k < 60; ++k) {
    plot += "PA0,0;CI800000000;";
    circles += "<circle r=\"20000000\"/>";
    curves += "<path d=\"M0 0C2e7 0 2e7 2e7 0 2e7\"/>";
    entities += "0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n20000000\n";
  }
  const std::string drawing = "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
  for (const std::string& text : {plot, svg(circles), svg(curves), drawing}) {
    ReadingOptions options;
    options.plain = true;
    options.unit = protocol::trade::LengthUnit::kMillimetre;
    options.tolerance = 1e-3;
    const auto file = read_file(text, options);
    ASSERT_FALSE(file) << text.substr(0, 60);
    EXPECT_EQ(file.error().code, ErrorCode::kOutOfRange);
    EXPECT_NE(file.error().message.find("the curves of this file need more than 100"), std::string::npos)
        << file.error().message;
  }
}

TEST(SvgIn, CubicsWithInflectionsHoldTheirArea) {
  const MarkerFile file = read_text(svg("<path d=\"M0 100 C100 0 200 200 300 100 L300 400 L0 400 z\"/>"));
  // The curve is symmetric about its middle, so the area is that of the rectangle.
  EXPECT_GE(area_of(file, 0), 300 * 300);
  EXPECT_LE(area_of(file, 0), 300 * 300 + 0.05 * 320);
}

TEST(SvgIn, TransformsNestAndUnitsComeFromTheViewBox) {
  const MarkerFile file = read_text(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"10in\" viewBox=\"0 0 100 80\"><g transform=\"translate(5,5) "
      "scale(2)\">"
      "<g id=\"A\" transform=\"rotate(90)\"><rect width=\"10\" height=\"20\"/></g></g></svg>");
  EXPECT_NEAR(extent_of(file, "A").x, 40 * 2.54, 1e-5);
  EXPECT_NEAR(extent_of(file, "A").y, 20 * 2.54, 1e-5);
}

TEST(SvgIn, ArcFlagsMayTouchAndRelativePathsAreFollowed) {
  const MarkerFile file = read_text(svg("<path d=\"m100 100 100 0a50 50 0 01-100 0z\"/>"));
  EXPECT_NEAR(extent_of(file, "piece").x, 100, 1e-6);
  EXPECT_NEAR(extent_of(file, "piece").y, 50, 0.1);
}

TEST(SvgIn, CutLineOutsideSewLineInsideHiddenLeftOut) {
  const MarkerFile file =
      read_text(svg("<defs><path d=\"M0 0H900V700H0z\"/></defs><path class=\"hidden\" d=\"M0 0H900V700H0z\"/><g "
                    "id=\"fs-x-part-cuff\">"
                    "<path class=\"fabric\" d=\"M10 10H110V60H10z\"/><path class=\"fabric sa\" d=\"M0 0H120V70H0z\"/>"
                    "<path class=\"note\" marker-start=\"url(#grainlineFrom)\" d=\"M60 60V10\"/></g>"));
  ASSERT_EQ(file.marker.shapes.size(), 1U);
  EXPECT_EQ(file.marker.shapes[0].id, "cuff");
  EXPECT_EQ(extent_of(file, "cuff").x, 70);  // the grain ran upwards
  const auto drawn = protocol::document::annotations_of(file.attributes.shapes[0]);
  std::size_t sew = 0;
  for (const auto& line : drawn.lines) sew += line.kind == protocol::document::LineKind::kSew;
  EXPECT_EQ(sew, 1U);
  EXPECT_EQ(file.attributes.shapes[0]["material"], "fabric");
}

TEST(SvgIn, UsesAndSymbolsAreDrawnWhereTheyAreUsed) {
  const MarkerFile file =
      read_text(svg("<defs><path id='p' d='M0 0h50v30h-50z'/></defs><use href='#p' x='10'/>"
                    "<use xlink:href='#p' transform='translate(200 100) rotate(90)'/><use href='#gone'/>"
                    "<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol>"
                    "<use href='#s' x='300' width='40' height='60'/>"
                    "<svg x='500' width='100' height='100' viewBox='0 0 10 10'><rect width='5' height='2'/></svg>"));
  ASSERT_EQ(file.marker.shapes.size(), 4U);
  std::vector<double> areas;
  for (std::size_t k = 0; k < 4; ++k) areas.push_back(area_of(file, k));
  std::sort(areas.begin(), areas.end());
  EXPECT_NEAR(areas[0], 1000, 1e-6);
  EXPECT_NEAR(areas[1], 1500, 1e-6);
  EXPECT_NEAR(areas[2], 1500, 1e-6);
  EXPECT_NEAR(areas[3], 1600, 1e-6);
  EXPECT_TRUE(test::has_note(file, "<use> of \"#gone\" is not read"));
}

TEST(SvgIn, SmallMarksThatAreUsedOnAnEdgeBelongToTheirPiece) {
  const MarkerFile file =
      read_text(svg("<defs><g id='notch'><circle r='1.4'/></g></defs><rect width='100' height='50'/>"
                    "<use href='#notch' x='50' y='50'/><use href='#notch' x='20' y='20'/>"));
  ASSERT_EQ(file.marker.shapes.size(), 1U);
  EXPECT_EQ(protocol::document::annotations_of(file.attributes.shapes[0]).lines.size(), 2U);
}

TEST(SvgIn, UsesThatMultiplyAreRefused) {
  std::string groups = "<defs><rect id='a0' width='1' height='1'/>";
  for (int k = 1; k < 10; ++k) {
    groups += "<g id='a" + std::to_string(k) + "'>";
    for (int copy = 0; copy < 10; ++copy) groups += "<use href='#a" + std::to_string(k - 1) + "'/>";
    groups += "</g>";
  }
  const auto file = read_file(svg(groups + "</defs><use href='#a9'/>"));
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kOutOfRange);
  EXPECT_FALSE(read_file(svg("<g id='a'><use href='#a'/></g>"))) << "a group that uses itself";
}

TEST(SvgIn, LengthsHaveUnitsAndPixelsAreANinetySixthOfAnInch) {
  const std::string pixels = "<svg width='960' height='960' viewBox='0 0 9600 9600'>";
  const MarkerFile small = read_text(pixels + "<rect width='9600' height='960'/></svg>");
  EXPECT_NEAR(extent_of(small, "piece").x, 254, 1e-5);
  const MarkerFile lengths =
      read_text("<svg width='254mm' height='254mm' viewBox='0 0 960 960'><rect width='100mm' height='2in'/></svg>");
  EXPECT_NEAR(extent_of(lengths, "piece").x, 100, 1e-5);
  EXPECT_NEAR(extent_of(lengths, "piece").y, 50.8, 1e-5);
}

TEST(SvgIn, RoundedRectanglesAreHeldWithinTheTolerance) {
  const double area = area_of(read_text(svg("<rect width='100' height='50' rx='10'/>")), 0);
  EXPECT_GE(area, 5000 - (4 - std::numbers::pi) * 100);
  EXPECT_LE(area, 5000 - (4 - std::numbers::pi) * 100 + 0.05 * 2 * std::numbers::pi * 10);
}

TEST(SvgIn, WhatIsNotReadIsNoted) {
  const MarkerFile file =
      read_text(svg("<style>.guide { stroke: red; display: none }</style><rect class='guide' width='900' height='700'/>"
                    "<rect width='100' height='50'/><text x='5' y='5'>FRONT</text><path d='M500 500l9 9'/>"
                    "<g transform='rotate(12'><rect x='200' width='10' height='10'/></g>"));
  EXPECT_EQ(file.marker.shapes.size(), 2U);
  EXPECT_TRUE(test::has_note(file, "<text> is not read"));
  EXPECT_TRUE(test::has_note(file, "1 open lines and marks outside of all pieces are left out"));
  EXPECT_TRUE(test::has_note(file, "the transform \"rotate(12\" is not read"));
}

TEST(SvgIn, NamesThatAreNotUtf8AreMadeSo) {
  const MarkerFile file = read_text(svg("<g id='A\xff'><rect width='100' height='50'/></g>"));
  EXPECT_EQ(file.marker.shapes.front().id, "A\xef\xbf\xbd");
}

TEST(SvgIn, BrokenXmlIsRefused) {
  const auto file = read_file("<svg><path");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kSyntax);
}

TEST(EsicupIn, WithoutASolutionPiecesLieInColumns) {
  const MarkerFile file = read_text(
      "<?xml version=\"1.0\"?><nesting><name>n</name><problem><boards><piece id=\"b\"><component "
      "idPolygon=\"p0\"/></piece></boards>"
      "<lot><piece id=\"x\" quantity=\"3\"><orientation><enumeration angle=\"0\"/><enumeration "
      "angle=\"90\"/></orientation>"
      "<component idPolygon=\"p1\"/></piece></lot></problem><polygons><polygon id=\"p0\"><lines><segment n=\"1\" "
      "x0=\"0\" y0=\"0\"/>"
      "<segment n=\"2\" x0=\"0\" y0=\"50\"/></lines></polygon><polygon id=\"p1\"><lines><segment x0=\" 0.0\" y0=\"0\"/>"
      "<segment x0=\"20\" y0=\"0\"/><segment x0=\"20\" y0=\"30\"/></lines></polygon></polygons></nesting>");
  EXPECT_EQ(file.marker.pieces.size(), 3U);
  EXPECT_EQ(to_decimal(file.marker.strip.width, file.marker.resolution), 50);
  EXPECT_EQ(file.marker.shapes[0].rotations.size(), 2U);
  EXPECT_TRUE(is_valid(file.marker));
}

TEST(EsicupIn, NumbersAreCheckedAndComponentsMoved) {
  const auto form = [](const std::string& x, const std::string& quantity) {
    return "<nesting><name>n</name><problem><lot><piece id='A' quantity='" + quantity +
           "'><component idPolygon='p' xOffset='7'/>"
           "</piece></lot></problem><polygons><polygon id='p'><lines><segment x0='0' y0='0'/><segment x0='" +
           x + "' y0='0'/><segment x0='0' y0='30'/></lines></polygon></polygons></nesting>";
  };
  EXPECT_NEAR(extent_of(read_text(form("50.5", "2")), "A").x, 50.5, 1e-6);
  const auto comma = read_file(form("50,5", "2"));
  ASSERT_FALSE(comma);
  EXPECT_NE(comma.error().message.find("x0 of <segment> is \"50,5\""), std::string::npos) << comma.error().message;
  EXPECT_FALSE(read_file(form("50", "two")));
  EXPECT_FALSE(read_file(form("50", "1.5")));
}

TEST(RealDrawings, AreRead) {
  const std::string albano = test::real_file("esicup/albano.xml"),
                    charlie = test::real_file("svg/freesewing_charlie.svg");
  if (albano.empty()) GTEST_SKIP() << "SELVAGE_TRADE_DATA does not name the folder of real files";
  const MarkerFile nest = read_text(albano);
  EXPECT_EQ(nest.marker.pieces.size(), 24U);
  EXPECT_EQ(nest.marker.shapes.size(), 8U);
  const MarkerFile trousers = read_text(charlie);
  EXPECT_EQ(trousers.marker.shapes.size(), 12U);
}

}  // namespace
}  // namespace selvage
