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

// Three squares of 100 mm side by side fill the width of the frame, which is 300 mm long and drawn twice.
TEST(HpglIn, PiecesMayTouchTheFrame) {
  const std::string frame = "PU0,0;PD12000,0,12000,4000,0,4000,0,0;";
  std::string squares;
  for (const int x : {0, 4000, 8000}) {
    const auto at = [&](int right, int up) { return std::to_string(x + right) + "," + std::to_string(up); };
    squares += "PU" + at(0, 0) + ";PD" + at(4000, 0) + "," + at(4000, 4000) + "," + at(0, 4000) + "," + at(0, 0) + ";";
  }
  const MarkerFile file = plot("IN;SP1;" + frame + squares + frame + "PU;");
  EXPECT_EQ(file.marker.pieces.size(), 3U);
  EXPECT_EQ(to_decimal(file.marker.strip.width, file.marker.resolution), 100);
  EXPECT_TRUE(is_valid(file.marker));
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

// A number as PE encodes it: in base 64, or in base 32 with seven bits.
std::string encoded(int number, int base = 64) {
  unsigned rest = number < 0 ? 2U * static_cast<unsigned>(-number) + 1 : 2U * static_cast<unsigned>(number);
  const auto digits = static_cast<unsigned>(base);
  std::string out;
  for (; rest >= digits; rest /= digits) out += static_cast<char>(63 + rest % digits);
  return out + static_cast<char>((base == 64 ? 191 : 95) + rest);
}
std::string encoded_square(int side, int base = 64) {
  const auto move = [&](int x, int y) { return encoded(x, base) + encoded(y, base); };
  return "<=" + move(400, 400) + move(side, 0) + move(0, side) + move(-side, 0) + move(0, -side);
}

TEST(HpglIn, EncodedPolylinesAreRead) {
  const std::string pen = ":" + encoded(1), fraction = ">" + encoded(3);
  for (const std::string& plot_text :
       {"IN;PE" + pen + encoded_square(8000) + ";SP0;", "IN;PE7" + encoded_square(8000, 32) + ";SP0;",
        "IN;PE\r\n" + fraction + encoded_square(64000) + ";SP0;"}) {
    const MarkerFile file = plot(plot_text);
    ASSERT_EQ(file.marker.pieces.size(), 1U);
    EXPECT_NEAR(area_of(file, 0), 200 * 200, 1e-6);
    EXPECT_FALSE(test::has_note(file, "PE")) << plot_text;
  }
}

TEST(HpglIn, DamagedEncodedPolylinesAreNotedWithTheirLine) {
  const std::string outline = "PU0,0;PD8000,0,8000,8000,0,8000,0,0;PU;";
  const MarkerFile file = plot("IN;" + outline + "\nPE" + encoded(4) + "(" + encoded(4) + ";");
  EXPECT_TRUE(test::has_note(file, "/line/2: PE: characters that encode no coordinate are skipped"));
  // The codes from 161 to 190 are no digits, neither first nor last ones.
  for (int code = 1; code < 256; ++code) plot("IN;" + outline + "PE" + static_cast<char>(code) + encoded(4) + ";PU;");
  const MarkerFile cut_off = plot("IN;" + outline + "\nPE" + encoded_square(100) + "????????????????????");
  EXPECT_TRUE(test::has_note(cut_off, "/line/2: PE has no semicolon at its end"));
}

TEST(HpglIn, UserUnitsAreScaledByThePointsOfThePlot) {
  const std::string square = "PU0,0;PD100,0,100,50,0,50,0,0;PU;";
  struct Case {
    std::string set_up;
    double width, height;  // millimetres
  };
  for (const Case& one : {Case{"IN;IP0,0,8000,8000;SC0,100,0,100;", 200, 100},
                          {"IN;SC0,100,0,100;IP0,0,8000,8000;", 200, 100},
                          {"IN;IP0,0,8000,4000;SC0,100,0,100,1;", 100, 50},
                          {"IN;IP8000,0,0,8000;SC0,100,0,100;", 200, 100},  // from right to left
                          {"IN;SC0,40,0,40,2;", 100, 50},
                          {"IN;IP0,0,8000,8000;SC0,100,0,100;SC;SC0,40,0,40,2;", 100, 50},
                          {"IN;IP0,0,8000,8000;SC0,100,0,100;DF;SC0,40,0,80,2;", 100, 100}}) {
    const MarkerFile file = plot(one.set_up + square);
    ASSERT_EQ(file.marker.pieces.size(), 1U) << one.set_up;
    const auto extent = test::extent_of(file, file.marker.shapes.front().id);
    EXPECT_NEAR(extent.x, one.width, 1e-6) << one.set_up;
    EXPECT_NEAR(extent.y, one.height, 1e-6) << one.set_up;
  }
}

TEST(HpglIn, ArcsCirclesAndRelativeMovesAreScaledToo) {
  const std::string scaled = "IN;IP0,0,8000,16000;SC0,100,0,100;";  // 2 mm and 4 mm
  const MarkerFile circle = plot(scaled + "PA50,50;CI20;");
  EXPECT_NEAR(area_of(circle, 0), std::numbers::pi * 40 * 80, 0.1 * 400);
  const MarkerFile half = plot(scaled + "PU70,50;PD;AA50,50,180;PR40,0;PU;");
  EXPECT_NEAR(area_of(half, 0), std::numbers::pi * 40 * 80 / 2, 0.1 * 400);
}

TEST(HpglIn, AScaleThatCannotBeFollowedIsNotedWithItsLine) {
  const std::string square = "PU0,0;PD8000,0,8000,8000,0,8000,0,0;PU;";
  for (const auto& [set_up, note] :
       {std::pair{"IN;\nSC0,100,0,100;\n", "/line/3: SC without IP: how large its paper is is not known"},
        {"IN;\nSC0,0,0,1;\n", "/line/2: SC is ignored: a range or factor of 0"},
        {"IN;\nSC0,1;\n", "/line/2: SC is ignored: 2 numbers where none or at least 4 are required"},
        {"IN;\nSC0,1,0,1,7;\n", "/line/2: SC is ignored: the type 7"}}) {
    const MarkerFile file = plot(set_up + square);
    EXPECT_NEAR(area_of(file, 0), 200 * 200, 1e-6) << set_up;
    EXPECT_TRUE(test::has_note(file, note)) << note;
  }
}

TEST(HpglIn, InstructionsNeedNoSemicolons) {
  for (const char* text :
       {"IN SP1 PU0,0 PD8000,0 PD8000,4000 PD0,4000 PD0,0 PU SP0", "INSP1PU0 0PD8000 0 8000 4000 0 4000 0 0PUSP0",
        "IN\nSP1\nPU+0+0\nPD8000+0+8000+4000\nPR-8000-0\nPD0-4000\nPU\n"}) {
    ASSERT_EQ(protocol::files::kind_of(text), FileKind::kHpgl) << text;
    EXPECT_NEAR(area_of(plot(text), 0), 200 * 100, 1e-6) << text;
  }
  EXPECT_FALSE(protocol::files::kind_of("INPUT of the pattern room")) << "a text that begins like an instruction";
}

TEST(HpglIn, ALabelWithoutItsEndDoesNotSwallowThePlot) {
  const MarkerFile file = plot("IN;PU400,400;LBFRONT\nPU0,0;PD8000,0,8000,4000,0,4000,0,0;PU;");
  EXPECT_EQ(file.marker.pieces.front().id, "FRONT");
  EXPECT_TRUE(test::has_note(file, "/line/1: a label without the mark that ends it"));
}

TEST(HpglIn, APlotWithoutOutlinesIsRefused) {
  const auto file = protocol::files::read_file("IN;SP1;PU0,0;PD100,100;SP0;");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kEmptyMarker);
}

}  // namespace
}  // namespace selvage
