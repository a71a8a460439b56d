// SVG, plain DXF and ESICUP in: curves, transforms, units.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/marker/validity.h"
#include "protocol/document/annotations.h"
#include "tests/protocol/trade/example.h"

namespace selvage {
namespace {

using protocol::files::read_file;
using protocol::trade::ReadingOptions;
using test::extent_of;

MarkerFile read(const std::string& text, const ReadingOptions& options = {}) {
  auto file = read_file(text, options);
  if (!file) throw std::runtime_error(file.error().message);
  return *std::move(file);
}

std::string svg(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1000mm\" height=\"800mm\" viewBox=\"0 0 1000 800\">" +
         content + "</svg>";
}

double area_of(const MarkerFile& file, std::size_t shape) {
  const double unit = to_decimal(1, file.marker.resolution);
  return static_cast<double>(geometry::doubled_area(file.marker.shapes[shape].outline)) / 2 * unit * unit;
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

// The outline holds the true circle, and lies within the tolerance of it.
TEST(Flattening, HoldsTheTrueCurve) {
  for (const double tolerance : {1.0, 0.1, 0.01}) {
    ReadingOptions options;
    options.tolerance = tolerance;
    const MarkerFile file = read(svg("<circle id=\"c\" cx=\"200\" cy=\"200\" r=\"100\"/>"), options);
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
  const MarkerFile file = read(svg("<path d=\"M0 0 H300 V200 H200 A50 50 0 0 0 100 200 H0 Z\"/>"));
  const double exact = 300 * 200 - 3.14159265358979 * 50 * 50 / 2;
  EXPECT_GE(area_of(file, 0), exact);
  EXPECT_LE(area_of(file, 0), exact + 0.05 * 160);
}

TEST(SvgIn, CubicsWithInflectionsHoldTheirArea) {
  const MarkerFile file = read(svg("<path d=\"M0 100 C100 0 200 200 300 100 L300 400 L0 400 z\"/>"));
  // The curve is symmetric about its middle, so the area is that of the rectangle.
  EXPECT_GE(area_of(file, 0), 300 * 300);
  EXPECT_LE(area_of(file, 0), 300 * 300 + 0.05 * 320);
}

TEST(SvgIn, TransformsNestAndUnitsComeFromTheViewBox) {
  const MarkerFile file = read(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"10in\" viewBox=\"0 0 100 80\"><g transform=\"translate(5,5) "
      "scale(2)\">"
      "<g id=\"A\" transform=\"rotate(90)\"><rect width=\"10\" height=\"20\"/></g></g></svg>");
  EXPECT_NEAR(extent_of(file, "A").x, 40 * 2.54, 1e-5);
  EXPECT_NEAR(extent_of(file, "A").y, 20 * 2.54, 1e-5);
}

TEST(SvgIn, ArcFlagsMayTouchAndRelativePathsAreFollowed) {
  const MarkerFile file = read(svg("<path d=\"m100 100 100 0a50 50 0 01-100 0z\"/>"));
  EXPECT_NEAR(extent_of(file, "piece").x, 100, 1e-6);
  EXPECT_NEAR(extent_of(file, "piece").y, 50, 0.1);
}

TEST(SvgIn, CutLineOutsideSewLineInsideHiddenLeftOut) {
  const MarkerFile file =
      read(svg("<defs><path d=\"M0 0H900V700H0z\"/></defs><path class=\"hidden\" d=\"M0 0H900V700H0z\"/><g "
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

TEST(SvgIn, BrokenXmlIsRefused) {
  const auto file = read_file("<svg><path");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kSyntax);
}

TEST(PlainDxf, ClosedOutlinesOfAnyLayerArePieces) {
  const std::string text =
      "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
      "0\nLWPOLYLINE\n8\ncut\n90\n4\n70\n1\n10\n0\n20\n0\n10\n200\n20\n0\n42\n1\n10\n200\n20\n100\n10\n0\n20\n100\n"
      "0\nCIRCLE\n8\nhole\n10\n50\n20\n50\n40\n10\n"
      "0\nLINE\n8\n0\n10\n300\n20\n0\n11\n400\n21\n0\n0\nARC\n8\n0\n10\n350\n20\n0\n40\n50\n50\n0\n51\n180\n"
      "0\nENDSEC\n0\nEOF\n";
  ReadingOptions plain;
  plain.plain = true;
  const MarkerFile file = read(text, plain);
  ASSERT_EQ(file.marker.shapes.size(), 2U);
  EXPECT_NEAR(extent_of(file, "piece 1").x, 250, 0.06);  // a half circle of radius 50 at its end
  EXPECT_GE(area_of(file, 0), 200 * 100 + 3.14159265 * 50 * 50 / 2);
  EXPECT_NEAR(extent_of(file, "piece 2").y, 50, 0.06);
  EXPECT_EQ(protocol::document::annotations_of(file.attributes.shapes[0]).lines.size(), 1U);
}

// A B-spline's basis function by its definition [Cox, de Boor].
double basis(const std::vector<double>& knots, std::size_t k, std::size_t degree, double t) {
  if (degree == 0) return knots[k] <= t && t < knots[k + 1] ? 1 : 0;
  const auto part = [](double over, double under) { return under > 0 ? over / under : 0; };
  return part(t - knots[k], knots[k + degree] - knots[k]) * basis(knots, k, degree - 1, t) +
         part(knots[k + degree + 1] - t, knots[k + degree + 1] - knots[k + 1]) * basis(knots, k + 1, degree - 1, t);
}

struct ControlledSpline {
  std::size_t degree;
  std::vector<double> knots;
  std::vector<std::pair<double, double>> controls;
};

// The area between a spline and the line that joins its ends.
double area_below(const ControlledSpline& spline) {
  constexpr int kSamples = 20'000;
  double area = 0;
  std::pair<double, double> last = spline.controls.front();
  for (int k = 1; k <= kSamples; ++k) {
    std::pair<double, double> at = spline.controls.back();
    if (k < kSamples) {
      at = {0, 0};
      for (std::size_t i = 0; i < spline.controls.size(); ++i) {
        const double weight = basis(spline.knots, i, spline.degree, static_cast<double>(k) / kSamples);
        at.first += weight * spline.controls[i].first;
        at.second += weight * spline.controls[i].second;
      }
    }
    area += (at.first - last.first) * (at.second + last.second) / 2;
    last = at;
  }
  return area;
}

TEST(PlainDxf, SplinesThatBulgeOutwardsAreHeld) {
  const std::vector<ControlledSpline> splines{
      {2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {200, 400}, {400, 0}}},
      {2, {0, 0, 0, 0.3, 1, 1, 1}, {{0, 0}, {50, 200}, {300, 250}, {400, 0}}},
      {3, {0, 0, 0, 0, 0.5, 1, 1, 1, 1}, {{0, 0}, {0, 200}, {200, 300}, {400, 200}, {400, 0}}},
      {1, {0, 0, 0.5, 1, 1}, {{0, 0}, {200, 300}, {400, 0}}},
  };
  for (const ControlledSpline& spline : splines) {
    std::string text =
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nSPLINE\n8\n0\n71\n" +
        std::to_string(spline.degree) + "\n";
    for (const double knot : spline.knots) text += "40\n" + std::to_string(knot) + "\n";
    for (const auto& [x, y] : spline.controls) {
      text += "10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n";
    }
    text += "0\nLINE\n8\n0\n10\n0\n20\n0\n11\n400\n21\n0\n0\nENDSEC\n0\nEOF\n";
    ReadingOptions options;
    options.tolerance = 1;
    options.plain = true;
    const double area = area_of(read(text, options), 0);
    const double exact = area_below(spline);
    EXPECT_GE(area, exact - 0.01) << spline.degree << ", " << spline.controls.size();
    EXPECT_LE(area, exact + 1'000) << spline.degree << ", " << spline.controls.size();
  }
}

TEST(EsicupIn, WithoutASolutionPiecesLieInColumns) {
  const MarkerFile file = read(
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

TEST(RealDrawings, AreRead) {
  const std::string albano = test::real_file("esicup/albano.xml"),
                    charlie = test::real_file("svg/freesewing_charlie.svg");
  if (albano.empty()) GTEST_SKIP() << "SELVAGE_TRADE_DATA does not name the folder of real files";
  const MarkerFile nest = read(albano);
  EXPECT_EQ(nest.marker.pieces.size(), 24U);
  EXPECT_EQ(nest.marker.shapes.size(), 8U);
  const MarkerFile trousers = read(charlie);
  EXPECT_EQ(trousers.marker.shapes.size(), 12U);
}

}  // namespace
}  // namespace selvage
