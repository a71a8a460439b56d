// Plain DXF in: closed outlines, splines, blocks and arrays of them.
#include <gtest/gtest.h>

#include <algorithm>
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
using test::area_of;
using test::extent_of;
using test::read_text;

TEST(PlainDxf, ClosedOutlinesOfAnyLayerArePieces) {
  const std::string text =
      "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
      "0\nLWPOLYLINE\n8\ncut\n90\n4\n70\n1\n10\n0\n20\n0\n10\n200\n20\n0\n42\n1\n10\n200\n20\n100\n10\n0\n20\n100\n"
      "0\nCIRCLE\n8\nhole\n10\n50\n20\n50\n40\n10\n"
      "0\nLINE\n8\n0\n10\n300\n20\n0\n11\n400\n21\n0\n0\nARC\n8\n0\n10\n350\n20\n0\n40\n50\n50\n0\n51\n180\n"
      "0\nENDSEC\n0\nEOF\n";
  ReadingOptions plain;
  plain.plain = true;
  const MarkerFile file = read_text(text, plain);
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

// Two blocks, of which B inserts A twice, once mirrored; ENTITIES is given.
std::string dxf_with_blocks(const std::string& entities) {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n"
         "0\nBLOCK\n2\nA\n10\n10\n20\n10\n0\nLWPOLYLINE\n8\n0\n70\n1\n10\n10\n20\n10\n10\n110\n20\n10\n10\n10\n20\n60\n"
         "0\nENDBLK\n0\nBLOCK\n2\nB\n0\nINSERT\n2\nA\n10\n0\n20\n0\n0\nINSERT\n2\nA\n10\n500\n20\n0\n41\n-"
         "1\n0\nENDBLK\n"
         "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" +
         entities + "0\nENDSEC\n0\nEOF\n";
}

TEST(PlainDxf, BlocksInsertBlocksAndArrays) {
  ReadingOptions plain;
  plain.plain = true;
  const MarkerFile nested = read_text(dxf_with_blocks("0\nINSERT\n2\nB\n10\n0\n20\n0\n50\n90\n"), plain);
  ASSERT_EQ(nested.marker.shapes.size(), 2U);
  EXPECT_NEAR(area_of(nested, 0), 2500, 1e-6);
  EXPECT_NEAR(extent_of(nested, "piece 1").x, 50, 1e-6) << "turned by a quarter";
  const MarkerFile array =
      read_text(dxf_with_blocks("0\nINSERT\n2\nA\n10\n0\n20\n0\n70\n3\n71\n2\n44\n400\n45\n300\n"), plain);
  EXPECT_EQ(array.marker.pieces.size(), 6U);
}

TEST(PlainDxf, WhatIsNotReadIsNoted) {
  ReadingOptions plain;
  plain.plain = true;
  const MarkerFile file =
      read_text(dxf_with_blocks("0\nINSERT\n2\nA\n10\n0\n20\n0\n0\nINSERT\n2\nZ\n0\nTEXT\n1\nhello\n"
                                "0\nLINE\n10\n900\n20\n0\n11\n990\n21\n0\n"),
                plain);
  EXPECT_TRUE(test::has_note(file, "INSERT of block \"Z\", which is not in the file"));
  EXPECT_TRUE(test::has_note(file, "TEXT is not read"));
  EXPECT_TRUE(test::has_note(file, "an open line outside of all pieces left out"));
}

TEST(PlainDxf, BlocksThatInsertThemselvesAreRefused) {
  ReadingOptions plain;
  plain.plain = true;
  std::string text = dxf_with_blocks("0\nINSERT\n2\nA\n");
  text.insert(text.find("0\nENDBLK\n"), "0\nINSERT\n2\nB\n");
  const auto file = read_file(text, plain);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kOutOfRange);
}

TEST(PlainDxf, WhatIsSeenFromBehindIsMirrored) {
  ReadingOptions plain;
  plain.plain = true;
  const std::string corner = "0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n10\n100\n20\n0\n10\n0\n20\n50\n";
  const MarkerFile front = read_text(dxf_with_blocks(corner), plain),
                   behind = read_text(dxf_with_blocks(corner + "230\n-1\n"), plain);
  const auto at_left = [](const MarkerFile& file) {
    const Polygon& outline = file.marker.shapes.front().outline;
    const Box box = box_of(outline);
    return std::count_if(outline.begin(), outline.end(), [&](Vec v) { return v.x == box.low.x; });
  };
  EXPECT_EQ(at_left(front), 2);
  EXPECT_EQ(at_left(behind), 1);
}

// A square of 100 mm at x.
std::string square(double x, const std::string& tags = "8\n0\n") {
  std::string text = "0\nLWPOLYLINE\n" + tags + "70\n1\n";
  for (const auto& [dx, y] : {std::pair{0, 0}, {100, 0}, {100, 100}, {0, 100}}) {
    text += "10\n" + std::to_string(x + dx) + "\n20\n" + std::to_string(y) + "\n";
  }
  return text;
}

TEST(PlainDxf, WhatIsNotSeenIsNotRead) {
  ReadingOptions plain;
  plain.plain = true;
  std::string text =
      dxf_with_blocks(square(0) + square(200, "8\nOFF\n") + square(400, "8\nFROZEN\n") + square(-50, "67\n1\n8\n0\n"));
  text.insert(
      text.find("0\nSECTION\n2\nBLOCKS"),
      "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\n0\n70\n0\n62\n7\n0\nLAYER\n2\nOFF\n70\n0\n62\n-7\n"
      "0\nLAYER\n2\nFROZEN\n70\n1\n62\n7\n0\nENDTAB\n0\nENDSEC\n");
  const MarkerFile file = read_text(text, plain);
  ASSERT_EQ(file.marker.pieces.size(), 1U);
  EXPECT_NEAR(area_of(file, 0), 100 * 100, 1e-6);
  EXPECT_TRUE(test::has_note(file, "layer \"FROZEN\" is frozen or off"));
  EXPECT_TRUE(test::has_note(file, "layer \"OFF\" is frozen or off"));
}

TEST(PlainDxf, AnOutlineThatIsDrawnAgainIsOnePiece) {
  ReadingOptions plain;
  plain.plain = true;
  const MarkerFile file = read_text(dxf_with_blocks(square(0) + square(0) + square(200)), plain);
  EXPECT_EQ(file.marker.pieces.size(), 2U);
  EXPECT_TRUE(test::has_note(file, "an outline is drawn again; read once"));
}

TEST(PlainDxf, AWholeEllipseMayEndARoundedTurnLater) {
  ReadingOptions plain;
  plain.plain = true;
  for (const char* end : {"6.28318530718", "6.2832", "6.283185"}) {
    const MarkerFile file = read_text(
        dxf_with_blocks(std::string{"0\nELLIPSE\n10\n0\n20\n0\n11\n200\n21\n0\n40\n0.5\n41\n0\n42\n"} + end + "\n"),
        plain);
    EXPECT_NEAR(area_of(file, 0), 3.14159265 * 200 * 100, 60) << end;
  }
}

TEST(PlainDxf, VerticesThatControlASplineAreNotOnIt) {
  ReadingOptions plain;
  plain.plain = true;
  std::string text = "0\nPOLYLINE\n8\n0\n70\n5\n";
  const auto add = [&](double x, double y, int flags) {
    text +=
        "0\nVERTEX\n10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n70\n" + std::to_string(flags) + "\n";
  };
  for (const auto& [x, y] : {std::pair{0, 0}, {100, -90}, {200, 0}, {200, 100}}) add(x, y, 16);
  for (const auto& [x, y] : {std::pair{0, 0}, {200, 0}, {200, 100}}) add(x, y, 8);
  EXPECT_NEAR(area_of(read_text(dxf_with_blocks(text + "0\nSEQEND\n"), plain), 0), 200 * 100 / 2, 1e-6);
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
    const double area = area_of(read_text(text, options), 0);
    const double exact = area_below(spline);
    EXPECT_GE(area, exact - 0.01) << spline.degree << ", " << spline.controls.size();
    EXPECT_LE(area, exact + 1'000) << spline.degree << ", " << spline.controls.size();
  }
}

}  // namespace
}  // namespace selvage
