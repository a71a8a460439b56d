// Plots in: pieces, frame, labels, arcs, and what is only noted.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "core/marker/validity.h"
#include "protocol/document/annotations.h"
#include "protocol/files/reading.h"
#include "protocol/files/writing.h"
#include "tests/protocol/trade/example.h"

namespace selvage {
namespace {

using protocol::files::FileFormat;
using protocol::files::FileKind;
using test::area_of;
using test::read_example;

MarkerFile plot(const std::string& text) {
  auto file = protocol::files::read_file(text);
  if (!file) throw std::runtime_error(file.error().message);
  return *std::move(file);
}
double length(const MarkerFile& file) {
  return to_decimal(length_of(file.marker), file.marker.resolution);
}

TEST(HpglIn, CommandsToThePrinterAroundItAreSkipped) {
  const MarkerFile file = plot(
      "\x1b%-12345X@PJL SET A=B\r\n@PJL ENTER LANGUAGE=HPGL2\r\n\x1b%0BIN;"
      "PU0,0;PD8000,0,8000,4000,0,4000,0,0;PU;\x1b%0A\x1b%-12345X");
  EXPECT_NEAR(area_of(file, 0), 200 * 100, 1e-6);
}

TEST(HpglIn, PiecesLieInTheFrameAndHaveTheirLabelsAsNames) {
  const MarkerFile file = read_example("plotter_like.plt");
  ASSERT_EQ(file.marker.pieces.size(), 3U);
  EXPECT_EQ(to_decimal(file.marker.strip.width, file.marker.resolution), 600);
  EXPECT_TRUE(test::has_note(file, "the rectangle around everything"));
  EXPECT_TRUE(test::has_note(file, "1 lines outside of all pieces"));
  EXPECT_EQ(length(file), 860);
  EXPECT_TRUE(is_valid(file.marker));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string& id = file.marker.pieces[k].id;
    const double area = area_of(file, file.marker.pieces[k].shape.value);
    if (id.starts_with("FRONT")) {
      EXPECT_DOUBLE_EQ(area, 400 * 250 + 200 * 50);
    }
    if (id.starts_with("BACK")) {
      EXPECT_DOUBLE_EQ(area, 350 * 250);
    }
    if (id.starts_with("POCKET")) {
      EXPECT_GE(area, 250 * 100 + std::numbers::pi * 50 * 50 / 2);  // a half circle at its end, flattened outwards
      EXPECT_LE(area, 250 * 100 + std::numbers::pi * 50 * 50 / 2 + 0.05 * 160);
    }
  }
}

TEST(HpglIn, DashedLinesAndCirclesBecomeInnerLines) {
  const MarkerFile file = read_example("plotter_like.plt");
  std::size_t lines = 0;
  for (const auto& attributes : file.attributes.shapes) {
    for (const auto& line : protocol::document::annotations_of(attributes).lines) {
      EXPECT_EQ(line.kind, protocol::document::LineKind::kInternal);
      ++lines;
    }
  }
  EXPECT_EQ(lines, 2U);
}

TEST(HpglIn, APlotOfOursIsReadBackToThePlottersUnit) {
  const MarkerFile file = read_example("polypattern_like.dxf");
  const auto text = protocol::files::write_marker(file, FileFormat::kHpgl);
  ASSERT_TRUE(text);
  ASSERT_EQ(protocol::files::kind_of(*text), FileKind::kHpgl);
  const MarkerFile back = plot(*text);
  ASSERT_EQ(back.marker.pieces.size(), file.marker.pieces.size());
  EXPECT_NEAR(length(back), length(file), 0.026);
  EXPECT_NEAR(to_decimal(back.marker.strip.width, back.marker.resolution),
              to_decimal(file.marker.strip.width, file.marker.resolution), 0.026);
}

TEST(HpglIn, RelativeCoordinatesRectanglesAndOtherEndsOfLabels) {
  const MarkerFile file =
      plot("IN;DT*;PA0,0;ER8000,4000;PU400,400;LBA*PU10000,0;PR;PD4000,0,0,4000,-4000,0,0,-4000;PU;PA;SP0;");
  ASSERT_EQ(file.marker.pieces.size(), 2U);
  EXPECT_EQ(length(file), 350);
  EXPECT_EQ(file.marker.pieces[0].id, "A");
}

TEST(HpglIn, UnsupportedInstructionsAreNoted) {
  const MarkerFile file = plot("IN;IP0,0,100,100;SC0,1,0,1;PU0,0;PD8000,0,8000,8000,0,8000,0,0;PE<=abc;SP0;");
  EXPECT_TRUE(test::has_note(file, "SC: scaling is not followed"));
  EXPECT_TRUE(test::has_note(file, "PE: encoded polylines are not read"));
}

TEST(HpglIn, APlotWithoutOutlinesIsRefused) {
  const auto file = protocol::files::read_file("IN;SP1;PU0,0;PD100,100;SP0;");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kEmptyMarker);
}

}  // namespace
}  // namespace selvage
