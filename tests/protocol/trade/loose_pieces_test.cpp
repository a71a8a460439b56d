// Pattern files without blocks: the pieces are drawn in ENTITIES, and their texts tell them apart.
#include <gtest/gtest.h>

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
using test::has_note;
using test::pieces_of;
using test::polyline;
using test::read_text;
using test::spot;
using test::tag;
using test::text;

const Corners kLeft{{0, 0}, {300, 0}, {300, 200}, {0, 200}}, kRight{{400, 0}, {500, 0}, {500, 50}, {400, 50}};

std::string without_blocks(const std::string& entities, const std::string& blocks = "") {
  return tag(0, "SECTION") + tag(2, "BLOCKS") + blocks + tag(0, "ENDSEC") + tag(0, "SECTION") + tag(2, "ENTITIES") +
         text("Units: METRIC", -100, -100) + text("Style Name: TEE", -100, -110) + entities + tag(0, "ENDSEC") +
         tag(0, "EOF");
}

TEST(LoosePieces, HaveTheTextsAndMarksThatLieInThem) {
  const std::string notch = tag(0, "POINT") + tag(8, "4") + spot(300, 70) + tag(30, "5");
  const std::string grain = tag(0, "LINE") + tag(8, "7") + spot(450, 10) + spot(450, 40, 11);
  const MarkerFile file = read_text(without_blocks(
      polyline(kLeft, true) + polyline(kRight, true) + text("Piece Name: CUFF", 410, 20) +
      text("Quantity: 1,1", 410, 10) + text("Piece Name: FRONT", 10, 100) + text("Size: M", 10, 90) + notch + grain));
  EXPECT_EQ(file.marker.name, "TEE");
  EXPECT_EQ(pieces_of(file, "CUFF"), 2U);
  EXPECT_EQ(pieces_of(file, "FRONT/M"), 1U);
  EXPECT_NEAR(extent_of(file, "CUFF").x, 50, 1e-6) << "turned onto its grain";
  EXPECT_TRUE(has_note(file, "no block draws a piece: every outermost closed line on layer 1 is one"));
  for (std::size_t k = 0; k < file.marker.shapes.size(); ++k) {
    const bool front = file.marker.shapes[k].id == "FRONT/M";
    EXPECT_EQ(protocol::document::annotations_of(file.attributes.shapes[k]).notches.size(), front ? 1U : 0U);
  }
}

TEST(LoosePieces, ATextBesideAPieceIsTakenForTheNearest) {
  const MarkerFile file = read_text(without_blocks(polyline(kLeft, true) + polyline(kRight, true) +
                                                   text("Piece Name: CUFF", 510, 20) + text("BODY", 100, 100)));
  EXPECT_EQ(pieces_of(file, "CUFF"), 1U);
  EXPECT_EQ(pieces_of(file, "BODY"), 1U);
  EXPECT_TRUE(has_note(file, "\"Piece Name: CUFF\" lies outside of all outlines"));
  EXPECT_TRUE(has_note(file, "no Piece Name: the first text in the outline is taken, \"BODY\""));
}

TEST(LoosePieces, OutlinesMayBeOfLinesWithGaps) {
  std::string lines;
  for (std::size_t k = 0; k < kLeft.size(); ++k) {
    const auto& [x, y] = kLeft[k];
    const auto& [to_x, to_y] = kLeft[(k + 1) % kLeft.size()];
    lines += tag(0, "LINE") + tag(8, "1") + spot(x, y) + spot(to_x, k == 1 ? to_y - 0.5 : to_y, 11);
  }
  const MarkerFile file = read_text(without_blocks(lines + text("Piece Name: A", 50, 50)));
  EXPECT_NEAR(area_of(file, 0), 300 * 200, 100);
  EXPECT_TRUE(has_note(file, "the boundary is open by 0.5 mm; closed"));
}

TEST(LoosePieces, AnOpenOutlineIsRefusedAndStrayLinesAreNoted) {
  Corners open = kLeft;
  open.emplace_back(0, 20);
  const auto file = read_file(without_blocks(polyline(open, false)));
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kTooFewVertices);
  const std::string stray = polyline({{900, 0}, {950, 0}}, false) + polyline({{20, 20}, {30, 30}, {40, 20}}, false);
  const MarkerFile read = read_text(without_blocks(polyline(kLeft, true) + stray));
  EXPECT_EQ(read.marker.shapes.size(), 1U);
  EXPECT_TRUE(has_note(read, "a line on layer 1 that meets no other is left out"));
  EXPECT_TRUE(has_note(read, "an open line on layer 1 inside of an outline is left out"));
}

TEST(LoosePieces, AreUnfoldedAndHaveTheBlocksInsertedInThem) {
  const std::string mirror = tag(0, "LINE") + tag(8, "6") + spot(0, 0) + spot(300, 0, 11);
  const std::string mark =
      tag(0, "BLOCK") + tag(2, "DRILL") + tag(0, "POINT") + tag(8, "13") + spot(0, 0) + tag(0, "ENDBLK");
  const std::string inserted = tag(0, "INSERT") + tag(8, "1") + tag(2, "DRILL") + spot(150, 100);
  const MarkerFile file = read_text(without_blocks(polyline(kLeft, true) + mirror + inserted, mark));
  EXPECT_NEAR(area_of(file, 0), 300 * 400, 1e-6);
  EXPECT_EQ(protocol::document::annotations_of(file.attributes.shapes.front()).drills.size(), 2U);
}

TEST(LoosePieces, BesideBlocksAreNotedAndNotRead) {
  const MarkerFile file = read_text(test::file_of(test::named("A"), text("Units: METRIC") + polyline(kRight, true)));
  EXPECT_EQ(file.marker.shapes.size(), 1U);
  EXPECT_TRUE(has_note(file, "1 lines on layer 1 outside of blocks are not read"));
}

}  // namespace
}  // namespace selvage
