#include "protocol/drawing/svg.h"

#include <gtest/gtest.h>

#include "protocol/drawing/label_spot.h"
#include "protocol/drawing/palette.h"
#include "tests/protocol/formats/samples.h"

namespace selvage::protocol::drawing {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Svg, DrawsEveryPieceWithItsId) {
  const MarkerFile file = test::read(test::native_squares());
  const std::string svg = to_svg(file.marker);
  EXPECT_EQ(count(svg, "<path class=\"piece\""), 2u);
  EXPECT_EQ(count(svg, ">left</text>"), 1u);
  EXPECT_EQ(count(svg, ">right</text>"), 1u);
  EXPECT_EQ(svg, to_svg(file.marker));
}

TEST(Svg, StatesLengthAndUtilisationBeforeAndAfter) {
  const MarkerFile file = test::read(test::native_squares());
  EXPECT_NE(to_svg(file.marker).find("length 90 mm  \u00b7  utilisation 35.556 %"), std::string::npos);
  SvgOptions options;
  options.length_before = to_lattice(100, file.marker.resolution);
  const std::string svg = to_svg(file.marker, options);
  EXPECT_NE(svg.find("100 \u2192 90 mm (\u221210.000 %)"), std::string::npos);
  EXPECT_EQ(count(svg, "class=\"before\""), 1u);
}

TEST(Svg, HasYUpwards) {
  Json document = test::native_squares();
  document["pieces"].erase(1);
  SvgOptions options;
  options.height = 100;  // a pixel per unit
  const std::string svg = to_svg(test::read(document).marker, options);
  // The square lies on the strip's lower edge: 60 to 100 pixels below the upper one, which is at 52.
  EXPECT_NE(svg.find("M46 152L86 152L86 112L46 112Z"), std::string::npos) << svg;
}

TEST(Svg, DrawsClothsRules) {
  Json document = test::native_squares();
  EXPECT_EQ(count(to_svg(test::read(document).marker), "selvedge"), 0u);
  document["strip"]["below"] = 10;
  document["strip"]["above"] = 5;
  document["shade"] = 200;
  document["strip"]["repeat"] = test::json(R"({"along": 40, "across": 50, "phase": [10, 0]})");
  document["pieces"][0]["rules"] =
      test::json(R"({"fold": true, "from": 0, "to": 80, "match": [10, 0], "shade": "<A>"})");
  document["pieces"][1]["rules"] = test::json(R"({"to": 80, "from": 20, "shade": "<A>"})");
  SvgOptions options;
  options.height = 100;  // a pixel per unit
  const std::string svg = to_svg(test::read(document).marker, options);
  EXPECT_EQ(count(svg, "<rect class=\"selvedge\""), 2u);
  EXPECT_NE(svg.find("<rect class=\"selvedge\" x=\"46\" y=\"142\" width=\"90\" height=\"10\"/>"), std::string::npos);
  EXPECT_EQ(count(svg, "class=\"fold\""), 1u);
  EXPECT_EQ(count(svg, "class=\"band\""), 3u);    // 0, 20 and 80
  EXPECT_EQ(count(svg, "class=\"repeat\""), 6u);  // at x = 10, 50 and 90, y = 0, 50 and 100
  EXPECT_EQ(count(svg, "class=\"match\""), 2u);
  EXPECT_EQ(count(svg, "class=\"shade\""), 1u);
  EXPECT_EQ(count(svg, "&lt;A&gt;"), 1u);
}

TEST(Svg, DrawsZonesApartFromPieces) {
  Json document = test::native_squares();
  EXPECT_EQ(count(to_svg(test::read(document).marker), "zone"), 0u);
  document["pieces"][0]["rules"] = test::json(R"({"zone": true})");
  const std::string svg = to_svg(test::read(document).marker);
  EXPECT_EQ(count(svg, "<path class=\"zone\""), 1u);
  EXPECT_EQ(count(svg, "<path class=\"piece\""), 1u);
  EXPECT_EQ(count(svg, "1 piece "), 1u);
}

TEST(Svg, HatchesZonesThatSomePiecesMayUse) {
  Json document = test::native_squares();
  document["pieces"][0]["rules"] = test::json(R"({"zone": true, "quality": 2})");
  const std::string svg = to_svg(test::read(document).marker);
  EXPECT_EQ(count(svg, "<path class=\"quality\""), 1u);
  EXPECT_EQ(count(svg, "<path class=\"zone\""), 0u);
  EXPECT_EQ(count(svg, "<pattern id=\"hatched\""), 1u);
  EXPECT_EQ(count(svg, "<title>left, quality 2</title>"), 1u);
}

TEST(Svg, DrawsThePartThatAcceptsLess) {
  Json document = test::native_squares();
  document["pieces"][0]["rules"] = test::json(R"({"quality": 1, "part": {"outline": [[0, 0], [5, 0], [0, 5]]}})");
  EXPECT_EQ(count(to_svg(test::read(document).marker), "<path class=\"part\""), 1u);
}

TEST(Svg, DrawsBothFoldsOfATube) {
  Json document = test::native_squares();
  document["strip"]["tube"] = true;
  EXPECT_EQ(count(to_svg(test::read(document).marker), "class=\"fold\""), 2u);
}

// One that extends beyond the cloth is cut off there, and one that lies beyond it has no name.
TEST(Svg, DrawsNothingOfAZoneBeyondTheCloth) {
  Json document = test::native_squares();
  document["pieces"][0]["rules"] = test::json(R"({"zone": true})");
  document["pieces"][0]["at"] = test::json("[-10, -10]");
  const std::string svg = to_svg(test::read(document).marker);
  EXPECT_EQ(count(svg, "<svg x=\"46\" y=\"52\" width=\"360\" height=\"400\" viewBox=\"46 52 360 400\">"), 1u);
  EXPECT_EQ(count(svg, ">left</text>"), 1u);
  document["pieces"][0]["at"] = test::json("[200, 0]");
  EXPECT_EQ(count(to_svg(test::read(document).marker), ">left</text>"), 0u);
}

TEST(Svg, AStripOfAnyLengthTakesAtMostAHundredRows) {
  Json document = test::native_squares();
  document["pieces"][1]["at"] = test::json("[5000000, 0]");
  const std::string svg = to_svg(test::read(document).marker);
  EXPECT_EQ(count(svg, "<svg x="), 100u);
  EXPECT_LT(svg.size(), 2'000'000u);
}

TEST(Svg, EscapesNames) {
  Json document = test::native_squares();
  document["name"] = "<script>&\"";
  document["pieces"][0]["id"] = "a<b";
  const std::string svg = to_svg(test::read(document).marker);
  EXPECT_EQ(svg.find("<script>"), std::string::npos);
  EXPECT_EQ(svg.find("a<b"), std::string::npos);
  EXPECT_NE(svg.find("&lt;script&gt;&amp;&quot;"), std::string::npos);
}

TEST(Svg, WritesABlankForACharacterThatXmlDoesNotHave) {
  Json document = test::native_squares();
  document["pieces"][0]["id"] =
      "a\x01"
      "b\xef\xbf\xbf"
      "c\xef\xbf\xbe"
      "d\xef\xbf\xbd"
      "e\n";
  const std::string svg = to_svg(test::read(document).marker);
  EXPECT_NE(svg.find(">a b c d\xef\xbf\xbd"
                     "e </"),
            std::string::npos);
}

TEST(Svg, IsAsWideAsItsCaption) {
  Json document = test::native_squares();
  document["name"] = std::string(200, 'n');
  const std::string svg = to_svg(test::read(document).marker);
  const double width = std::stod(svg.substr(svg.find("width=\"") + 7));
  EXPECT_GT(width, 200 * 17 * 0.5);  // 17 pixels high, and half as wide
}

// Squares of 40 in a strip of 100, the last of them at 1460: three rows of 500 pixels, and pixels are units.
Json long_marker() {
  Json document = test::native_squares();
  document["pieces"] = Json::array();
  for (const int x : {0, 480, 700, 1460}) {
    document["pieces"].push_back({{"id", "p" + std::to_string(x)}, {"shape", "square"}, {"at", Json::array({x, 0})}});
  }
  return document;
}

TEST(Svg, FoldsALongMarkerIntoRows) {
  SvgOptions options;
  options.height = 100;
  const std::string svg = to_svg(test::read(long_marker()).marker, options);
  EXPECT_EQ(count(svg, "<svg "), 4u);                // the drawing, and what each of the three rows shows
  EXPECT_EQ(count(svg, "class=\"cut\""), 4u);        // two ends of rows, each drawn in both of them
  EXPECT_EQ(count(svg, "<title>p480</title>"), 2u);  // it lies across the end of the first row
  EXPECT_EQ(count(svg, ">p480</text>"), 1u);         // but its label is written once
  EXPECT_EQ(count(svg, "<title>p700</title>"), 1u);
  EXPECT_EQ(count(svg, ">p1460</text>"), 1u);
  EXPECT_EQ(svg.rfind("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"616\" height=\"520\"", 0), 0u)
      << svg.substr(0, 99);
  // At 700, which is 200 in the second row, whose cloth begins 164 pixels below that of the first.
  EXPECT_NE(svg.find("M246 316L286 316L286 276L246 276Z"), std::string::npos) << svg;
}

TEST(Svg, KeepsLabelsWithinTheirRows) {
  SvgOptions options;
  options.height = 100;
  options.labels = {"", "abcdef", "", ""};
  const std::string svg = to_svg(test::read(long_marker()).marker, options);
  const std::size_t end = svg.find(">abcdef");
  ASSERT_NE(end, std::string::npos);
  const std::size_t x = svg.rfind(" x=\"", end) + 4;
  EXPECT_GT(std::stod(svg.substr(x)), 46 + 10);  // the square's middle is at the beginning of the second row
}

TEST(Svg, ContinuesTheRulerFromRowToRow) {
  SvgOptions options;
  options.height = 100;
  const std::string svg = to_svg(test::read(long_marker()).marker, options);
  for (const char* number : {">400</text>", ">600</text>", ">1400</text>"}) EXPECT_EQ(count(svg, number), 1u) << number;
}

TEST(Svg, DoesNotFoldAMarkerOfSixTimesItsWidth) {
  Json document = long_marker();
  document["pieces"][2]["at"][0] = 300;
  document["pieces"][3]["at"][0] = 560;  // it ends at 600
  const std::string svg = to_svg(test::read(document).marker);
  EXPECT_EQ(count(svg, "<svg "), 1u);
  EXPECT_EQ(count(svg, "class=\"cut\""), 0u);
}

TEST(Svg, WritesLabelsOnTopOfTheCriticalPath) {
  const MarkerFile file = test::read(test::native_squares());
  SvgOptions options;
  options.overlay.chain.push_back({.x = 1, .y = 1, .from_x = 0, .from_y = 0, .to_x = 2, .to_y = 2, .worth = 1});
  const std::string svg = to_svg(file.marker, options);
  ASSERT_NE(svg.find("class=\"chain\""), std::string::npos);
  EXPECT_LT(svg.rfind("class=\"chain\""), svg.find("<g class=\"over\">"));
  EXPECT_LT(svg.find("<g class=\"over\">"), svg.find(">left</text>"));
}

TEST(LabelSpot, LiesInsideTheRoomiestPart) {
  // An L: the middle of its box is outside, the foot is wider than the stem.
  const Polygon l{{0, 0}, {1000, 0}, {1000, 300}, {100, 300}, {100, 1000}, {0, 1000}};
  const LabelSpot spot = find_label_spot(l, 3, 50);
  EXPECT_EQ(locate({static_cast<Coord>(spot.x), static_cast<Coord>(spot.y)}, l), geometry::Location::kInside);
  EXPECT_LT(spot.y, 300);
  EXPECT_FALSE(spot.upright);
  EXPECT_GT(spot.half_height, 25);
}

TEST(LabelSpot, TurnsTheTextInANarrowUprightPiece) {
  const Polygon tall{{0, 0}, {100, 0}, {100, 2000}, {0, 2000}};
  EXPECT_TRUE(find_label_spot(tall, 6, 100).upright);
}

TEST(Palette, MirrorImagesShareAHueAndNeighboursDoNot) {
  Json document = test::native_squares();
  document["shapes"] = test::json(R"([
    {"id": "l", "outline": [[0,0],[30,0],[30,10],[10,10],[10,30],[0,30]]},
    {"id": "r", "outline": [[0,0],[30,0],[30,30],[20,30],[20,10],[0,10]]},
    {"id": "square", "outline": [[0,0],[40,0],[40,40],[0,40]]}])");
  document["pieces"] = test::json(R"([
    {"id": "a", "shape": "l", "at": [0,0]}, {"id": "b", "shape": "r", "at": [30,0]},
    {"id": "c", "shape": "square", "at": [60,0]}])");
  const Marker marker = test::read(document).marker;
  std::vector<Polygon> placed;
  for (std::uint32_t i = 0; i < 3; ++i) placed.push_back(placed_outline(marker, PieceId{i}));
  const auto colours = shape_colours(marker, placed);
  ASSERT_EQ(colours.size(), 3u);
  EXPECT_NE(colours[0], colours[2]);
  EXPECT_NE(colours[1], colours[2]);
  EXPECT_NE(colours[0], colours[1]);  // a shade apart
  const auto red = [](const std::string& c) { return std::stoi(c.substr(1, 2), nullptr, 16); };
  EXPECT_NEAR(red(colours[1]), 0.9 * red(colours[0]), 1);
}

}  // namespace
}  // namespace selvage::protocol::drawing
