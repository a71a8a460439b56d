// Pattern files whose blocks insert blocks: pieces made of several, collections of pieces, and files that ask for
// billions of entities.
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
using test::named;
using test::polyline;
using test::read_text;
using test::spot;
using test::tag;
using test::text;

constexpr double kDrawnArea = 300 * 200 + 300 * 60 / 2.0;  // of kOutline

std::string block_of(const std::string& name, const std::string& entities) {
  return tag(0, "BLOCK") + tag(2, name) + entities + tag(0, "ENDBLK");
}
std::string placed(const std::string& name, const std::string& how = spot(0, 0), const std::string& layer = "1") {
  return tag(0, "INSERT") + tag(8, layer) + tag(2, name) + how;
}
std::string blocks_in_file(const std::string& blocks, const std::string& entities) {
  return tag(0, "SECTION") + tag(2, "BLOCKS") + blocks + tag(0, "ENDSEC") + tag(0, "SECTION") + tag(2, "ENTITIES") +
         entities + text("Units: METRIC") + tag(0, "ENDSEC") + tag(0, "EOF");
}

TEST(NestedBlocks, TheOutlineOfAPieceMayStandInAnotherBlock) {
  const std::string turned = spot(500, 70) + tag(41, "2") + tag(42, "2") + tag(50, "90");
  const MarkerFile read =
      read_text(blocks_in_file(block_of("EDGE", polyline(test::kOutline, true)) +
                                   block_of("FRONT", text("Piece Name: FRONT") + placed("EDGE", turned)),
                               placed("FRONT")));
  ASSERT_EQ(read.marker.shapes.size(), 1U);
  EXPECT_EQ(read.marker.shapes.front().id, "FRONT");
  EXPECT_NEAR(extent_of(read, "FRONT").x, 2 * 260, 1e-6);
  EXPECT_NEAR(extent_of(read, "FRONT").y, 2 * 300, 1e-6);
  EXPECT_TRUE(has_note(read, "block \"EDGE\" is inserted in other blocks and read as a part of them"));
}

TEST(NestedBlocks, MirroredHalvesMakeAnOutline) {
  const std::string half = polyline({{0, 0}, {100, 0}, {100, 80}, {0, 100}}, false);
  const MarkerFile read = read_text(blocks_in_file(
      block_of("HALF", half) + block_of("A", named("A", placed("HALF") + placed("HALF", spot(0, 0) + tag(41, "-1")))),
      placed("A")));
  EXPECT_NEAR(extent_of(read, "A").x, 200, 1e-6);
  EXPECT_NEAR(area_of(read, 0), 200 * 90, 1e-6);
}

TEST(NestedBlocks, NotchesAndTextsMoveWithTheirBlock) {
  const std::string mark =
      tag(0, "POINT") + tag(8, "4") + spot(0, 0) + tag(30, "5") + tag(50, "0") + text("on fold", 10, 0);
  const MarkerFile read = read_text(blocks_in_file(
      block_of("MARK", mark) +
          block_of("A", named("A") + placed("MARK", spot(300, 100) + tag(41, "2") + tag(42, "2") + tag(50, "90"))),
      placed("A")));
  const auto drawn = protocol::document::annotations_of(read.attributes.shapes.front());
  ASSERT_EQ(drawn.notches.size(), 1U);
  EXPECT_NEAR(drawn.notches[0].at.x, 300, 1e-6);
  EXPECT_NEAR(drawn.notches[0].depth, 10, 1e-6);
  EXPECT_NEAR(drawn.notches[0].angle.value_or(0), 90, 1e-6);
  ASSERT_EQ(drawn.texts.size(), 1U);
  EXPECT_NEAR(drawn.texts[0].at.y, 120, 1e-6);
}

TEST(NestedBlocks, WhatLiesOnLayerZeroTakesTheLayerOfItsInsert) {
  const MarkerFile read = read_text(blocks_in_file(block_of("EDGE", polyline(test::kOutline, true, "0")) +
                                                       block_of("A", named("A", placed("EDGE", spot(0, 0), "1"))),
                                                   placed("A")));
  EXPECT_NEAR(area_of(read, 0), kDrawnArea, 1e-6);
}

TEST(NestedBlocks, ABlockOfAllPiecesIsNoPiece) {
  const std::string pieces = block_of("FRONT", named("FRONT")) + block_of("BACK", named("BACK"));
  const std::string all = block_of("STYLE", placed("FRONT") + placed("BACK", spot(900, 0) + tag(41, "-1")));
  const MarkerFile read = read_text(blocks_in_file(pieces + all, placed("STYLE")));
  ASSERT_EQ(read.marker.shapes.size(), 2U);
  EXPECT_TRUE(has_note(read, "block \"STYLE\" only collects the pieces that it inserts"));
  EXPECT_TRUE(has_note(read, "block \"BACK\" is inserted mirrored"));
  EXPECT_FALSE(has_note(read, "never inserted"));
}

TEST(NestedBlocks, ThePiecesOwnTextsCountFirst) {
  const std::string inner = text("Piece Name: INNER") + text("Quantity: 5") + polyline(test::kOutline, true);
  const MarkerFile read = read_text(blocks_in_file(
      block_of("INNER", inner) + block_of("A", placed("INNER") + text("Piece Name: A") + text("Quantity: 2")),
      placed("A")));
  EXPECT_EQ(test::pieces_of(read, "A"), 2U);
  EXPECT_TRUE(has_note(read, "PIECE NAME is given again"));
}

TEST(NestedBlocks, AMissingBlockIsNotedWithItsLine) {
  const std::string blocks = block_of("A", named("A") + placed("LOGO"));
  const MarkerFile read = read_text(blocks_in_file(blocks, placed("A")));
  EXPECT_TRUE(has_note(read, "INSERT of block \"LOGO\", which is not in the file"));
  for (const Note& note : read.notes) {
    if (note.text.find("LOGO") == std::string::npos) continue;
    EXPECT_TRUE(note.field.starts_with("/line/")) << note.field;
  }
}

// Twelve blocks, each of which inserts the one before ten times: a million million lines.
TEST(NestedBlocks, ThatMultiplyAreRefused) {
  std::string blocks = block_of("L0", polyline({{0, 0}, {1, 1}}, false, "8"));
  for (int level = 1; level <= 12; ++level) {
    std::string ten;
    for (int k = 0; k < 10; ++k) ten += placed("L" + std::to_string(level - 1));
    blocks += block_of("L" + std::to_string(level), ten);
  }
  const auto read = read_file(blocks_in_file(blocks + block_of("A", named("A") + placed("L12")), placed("A")));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kOutOfRange);
  EXPECT_TRUE(read.error().field.starts_with("/line/")) << read.error().field;
  EXPECT_NE(read.error().message.find("500,000"), std::string::npos) << read.error().message;
}

TEST(NestedBlocks, AnArrayOfALongLineIsRefused) {
  Corners line;
  for (int k = 0; k < 2000; ++k) line.emplace_back(k, k % 7);
  const std::string array = spot(0, 0) + tag(70, "1000") + tag(71, "1000");
  const auto read = read_file(blocks_in_file(
      block_of("LONG", polyline(line, false, "8")) + block_of("A", named("A") + placed("LONG", array)), placed("A")));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kOutOfRange);
}

TEST(NestedBlocks, ThatInsertThemselvesAreRefused) {
  const std::string mutual = block_of("A", named("A") + placed("B")) + block_of("B", named("B") + placed("A"));
  for (const std::string& blocks : {block_of("A", named("A") + placed("A")), mutual}) {
    const auto read = read_file(blocks_in_file(blocks, placed("A")));
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.find("nested more than 16 deep"), std::string::npos) << read.error().message;
  }
}

TEST(NestedBlocks, AScaleOfScalesBeyondAllBoundsIsRefused) {
  std::string blocks = block_of("L0", polyline(test::kOutline, true));
  for (int level = 1; level <= 8; ++level) {
    blocks += block_of("L" + std::to_string(level),
                       placed("L" + std::to_string(level - 1), spot(0, 0) + tag(41, "1e8") + tag(42, "1e8")));
  }
  const auto read = read_file(blocks_in_file(blocks + block_of("A", named("A", placed("L8"))), placed("A")));
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("at most 1e12 is allowed"), std::string::npos) << read.error().message;
}

TEST(NestedBlocks, AScaleOrAnAngleThatIsNoNumberIsRefusedWithItsLine) {
  for (const int code : {41, 42, 50}) {
    const auto read = read_file(blocks_in_file(block_of("A", named("A")), placed("A", spot(0, 0) + tag(code, "nan"))));
    ASSERT_FALSE(read) << code;
    EXPECT_EQ(read.error().code, ErrorCode::kSyntax);
    EXPECT_NE(read.error().message.find("\"nan\" where a number is required"), std::string::npos)
        << read.error().message;
  }
}

}  // namespace
}  // namespace selvage
