// Half pieces whose outlines meet their mirror line more than once.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/marker/validity.h"
#include "protocol/document/annotations.h"
#include "protocol/trade/loops.h"
#include "tests/protocol/trade/example.h"
#include "tests/protocol/trade/pattern_text.h"

namespace selvage {
namespace {

using protocol::document::LineKind;
using test::area_of;
using test::Corners;
using test::extent_of;
using test::file_of;
using test::has_note;
using test::named;
using test::polyline;
using test::read_text;
using test::spot;
using test::tag;

std::string mirror_line(double from, double to) {
  return tag(0, "LINE") + tag(8, "6") + spot(from, 0) + spot(to, 0, 11);
}

// The areas of the openings that are cut out of the first shape.
std::vector<double> openings_of(const MarkerFile& file) {
  std::vector<double> areas;
  for (const auto& line : protocol::document::annotations_of(file.attributes.shapes.front()).lines) {
    if (line.kind == LineKind::kCutOut && line.closed)
      areas.push_back(std::abs(protocol::trade::doubled_area(line.points)) / 2);
  }
  return areas;
}

TEST(Unfolding, WhatLiesBetweenTwoEdgesOnTheMirrorLineIsAnOpening) {
  const Corners half{{0, 0}, {90, 0}, {90, 50}, {200, 50}, {200, 0}, {300, 0}, {300, 100}, {0, 100}};
  for (const auto& mirror : {mirror_line(0, 300), mirror_line(0, 90) + mirror_line(200, 300), mirror_line(300, 0)}) {
    for (std::size_t first = 0; first < half.size(); ++first) {
      Corners from = half;
      std::rotate(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(first), from.end());
      const MarkerFile file = read_text(file_of(named("A", polyline(from, true)) + mirror));
      EXPECT_NEAR(area_of(file, 0), 300 * 200, 1e-6) << first;
      ASSERT_EQ(openings_of(file).size(), 1U) << first;
      EXPECT_NEAR(openings_of(file)[0], 110 * 100, 1e-6) << first;
      EXPECT_TRUE(has_note(file, "1 opening is cut out of the unfolded piece"));
      EXPECT_FALSE(has_note(file, "mirror lines; the first counts"));
    }
  }
}

TEST(Unfolding, AnOutlineMayTouchItsMirrorLine) {
  const Corners half{{0, 0}, {100, 0}, {125, 40}, {150, 0}, {175, 40}, {200, 0}, {300, 0}, {300, 100}, {0, 100}};
  const MarkerFile file = read_text(file_of(named("A", polyline(half, true)) + mirror_line(0, 300)));
  EXPECT_NEAR(area_of(file, 0), 300 * 200, 1e-6);
  ASSERT_EQ(openings_of(file).size(), 2U);
  EXPECT_NEAR(openings_of(file)[0], 50 * 40, 1e-6);
  EXPECT_TRUE(has_note(file, "2 openings are cut out"));
}

// A collar whose point crosses the extension of its centre line: its reflection would lie on it.
TEST(Unfolding, APieceThatReachesBeyondItsMirrorLineLiesAsDrawn) {
  const Corners collar{{0, 0}, {60, 0}, {60, 60}, {200, 60}, {240, -20}, {260, 80}, {0, 80}};
  const MarkerFile file = read_text(file_of(named("A", polyline(collar, true)) + mirror_line(0, 60)));
  EXPECT_NEAR(extent_of(file, "A").y, 100, 1e-6);
  EXPECT_TRUE(has_note(file, "the piece reaches 20 mm beyond its mirror line"));
  const auto drawn = protocol::document::annotations_of(file.attributes.shapes.front()).lines;
  EXPECT_TRUE(std::any_of(drawn.begin(), drawn.end(), [](const auto& line) { return line.kind == LineKind::kMirror; }));
}

TEST(Unfolding, AHalfMillimetreBeyondTheMirrorLineIsInaccurate) {
  const Corners half{{0, 0}, {200, 0}, {250, 40}, {300, -0.5}, {300, 100}, {0, 100}};
  const MarkerFile file = read_text(file_of(named("A", polyline(half, true)) + mirror_line(0, 200)));
  EXPECT_NEAR(extent_of(file, "A").y, 200, 1e-6);
  EXPECT_TRUE(has_note(file, "a half piece, unfolded about its mirror line"));
}

}  // namespace
}  // namespace selvage
