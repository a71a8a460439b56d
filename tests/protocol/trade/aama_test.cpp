// Pattern files in the habits of the writers that were measured: what is made of each.
#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "protocol/document/annotations.h"
#include "tests/protocol/trade/example.h"

namespace selvage {
namespace {

using protocol::document::annotations_of;
using protocol::document::LineKind;
using protocol::trade::ReadingOptions;
using test::extent_of;
using test::has_note;
using test::pieces_of;
using test::read_example;

protocol::document::Annotations annotations(const MarkerFile& file, const std::string& shape) {
  for (std::size_t k = 0; k < file.marker.shapes.size(); ++k) {
    if (file.marker.shapes[k].id == shape) return annotations_of(file.attributes.shapes[k]);
  }
  ADD_FAILURE() << "no shape " << shape;
  return {};
}

TEST(AccuMarkLike, NestHasEverySizeAndSharesFieldsOfTheSampleSize) {
  const MarkerFile file = read_example("accumark_like_nest.dxf");
  EXPECT_EQ(file.marker.shapes.size(), 6U);
  EXPECT_EQ(pieces_of(file, "BAND/30"), 1U);
  EXPECT_EQ(pieces_of(file, "FRONT/34"), 2U);  // its quantity stands in the block of size 32 alone
  EXPECT_TRUE(is_valid(file.marker));
  EXPECT_TRUE(has_note(file, "unit: in"));
  EXPECT_TRUE(has_note(file, "/line/52: 2 repeated vertices left out"));
}

TEST(AccuMarkLike, HalfPieceIsUnfoldedAboutItsMirrorLine) {
  const MarkerFile file = read_example("accumark_like_nest.dxf");
  // 7.5 in of half a waistband: 15 in, across the grain.
  EXPECT_DOUBLE_EQ(extent_of(file, "BAND/32").x, 1.5 * 25.4);
  EXPECT_DOUBLE_EQ(extent_of(file, "BAND/32").y, 15 * 25.4);
  ReadingOptions keep;
  keep.fold = protocol::trade::FoldRule::kKeep;
  EXPECT_DOUBLE_EQ(extent_of(read_example("accumark_like_nest.dxf", keep), "BAND/32").y, 7.5 * 25.4);
}

TEST(AccuMarkLike, OnClothInTwoLayersHalfPiecesLieOnTheFoldAndTheOthersArePairs) {
  ReadingOptions lay;
  lay.fold = protocol::trade::FoldRule::kLay;
  const MarkerFile file = read_example("accumark_like_nest.dxf", lay);
  const MarkerFile unfolded = read_example("accumark_like_nest.dxf");
  EXPECT_DOUBLE_EQ(extent_of(file, "BAND/32").y, 7.5 * 25.4);
  EXPECT_EQ(pieces_of(file, "BAND/32"), pieces_of(unfolded, "BAND/32")) << "laid on the fold, it is cut as a whole one";
  EXPECT_EQ(pieces_of(file, "FRONT/34"), 1U) << "its two layers make the two";
  EXPECT_TRUE(has_note(file, "FRONT: 2 are cut as 1 pair from two layers"));
  for (std::size_t k = 0; k < file.marker.pieces.size(); ++k) {
    const Piece& piece = file.marker.pieces[k];
    const bool band = file.marker.shapes[piece.shape.value].id.starts_with("BAND");
    EXPECT_EQ(piece.rules.on_fold, band);
    EXPECT_EQ(file.marker.shapes[piece.shape.value].may_flip, band);
    EXPECT_EQ(file.attributes.shapes[piece.shape.value].contains("layers"), !band);
  }
  EXPECT_TRUE(is_valid(file.marker));
}

TEST(AccuMarkLike, AHalfPieceAboveItsMirrorLineIsTurnedOver) {
  ReadingOptions lay;
  lay.fold = protocol::trade::FoldRule::kLay;
  std::string text = test::example("accumark_like_nest.dxf");
  // The grain runs the other way: the piece is turned by 180 degrees, and its mirror line comes to lie above.
  const std::string grain = "8\r\n7\r\n10\r\n-49.5000\r\n20\r\n113.0000\r\n11\r\n-48.8000";
  const std::string back = "8\r\n7\r\n10\r\n-48.8000\r\n20\r\n113.0000\r\n11\r\n-49.5000";
  const auto without_returns = [](std::string with) {
    std::erase(with, '\r');
    return with;
  };
  const auto unspaced = [](std::string with) {
    for (std::size_t at = 0; (at = with.find("\n ", at)) != std::string::npos;) with.erase(at + 1, 1);
    return with;
  };
  text = unspaced(without_returns(text));
  ASSERT_NE(text.find(without_returns(grain)), std::string::npos);
  for (std::size_t at = 0; (at = text.find(without_returns(grain), at)) != std::string::npos;)
    text.replace(at, without_returns(grain).size(), without_returns(back));
  const auto file = protocol::files::read_file(text, lay);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_DOUBLE_EQ(extent_of(*file, "BAND/32").y, 7.5 * 25.4);
  EXPECT_TRUE(is_valid(file->marker)) << "its lower side is straight and lies on the fold";
  EXPECT_TRUE(std::any_of(file->marker.pieces.begin(), file->marker.pieces.end(),
                          [](const Piece& piece) { return piece.rules.on_fold; }));
}

TEST(AccuMarkLike, LinesMarkedNmAndNotchesOnTheFoldAreNotMirrored) {
  const MarkerFile file = read_example("accumark_like_nest.dxf");
  for (const char* shape : {"BAND/30", "BAND/32"}) {
    const auto drawn = annotations(file, shape);
    std::size_t internal = 0;
    for (const auto& line : drawn.lines) internal += line.kind == LineKind::kInternal;
    EXPECT_EQ(internal, 3U) << shape;  // one once (NM), one on both halves
  }
  EXPECT_EQ(annotations(file, "BAND/32").notches.size(), 3U);  // one on the mirror line, one on both halves
}

TEST(RichpeaceLike, ValidationCopiesAreIgnoredAndGbkIsRead) {
  const MarkerFile file = read_example("richpeace_like.dxf");
  ASSERT_EQ(file.marker.shapes.size(), 1U);
  EXPECT_EQ(file.marker.shapes[0].outline.size(), 6U);
  EXPECT_EQ(pieces_of(file, "SLEEVE"), 2U);
  EXPECT_TRUE(has_note(file, "texts are read as GBK"));
  EXPECT_TRUE(has_note(file, "the file does not say whether some of them are mirrored"));
  const auto drawn = annotations(file, "SLEEVE");
  ASSERT_EQ(drawn.notches.size(), 1U);
  EXPECT_EQ(drawn.notches[0].kind, protocol::document::NotchKind::kT);
  EXPECT_NEAR(drawn.notches[0].depth, 0.0984 * 25.4, 1e-6);
  EXPECT_EQ(drawn.notches[0].angle, 90.0);
}

TEST(RichpeaceLike, RuleTableMakesTheSizes) {
  ReadingOptions options;
  options.rules = test::example("richpeace_like.rul");
  const MarkerFile file = read_example("richpeace_like.dxf", options);
  EXPECT_EQ(file.marker.shapes.size(), 3U);
  EXPECT_NEAR(extent_of(file, "SLEEVE/L").x, 20 * 25.4, 1e-6);
  EXPECT_NEAR(extent_of(file, "SLEEVE/M").x, 19 * 25.4, 1e-6);
  EXPECT_NEAR(extent_of(file, "SLEEVE/XL").x, 21 * 25.4, 1e-6);
  EXPECT_NEAR(extent_of(file, "SLEEVE/XL").y, 10.5 * 25.4, 1e-6);
}

TEST(RichpeaceLike, PointsBetweenGradedOnesMoveByArcLength) {
  ReadingOptions options;
  options.rules = test::example("richpeace_like.rul");
  options.sizes = {"XL"};
  const MarkerFile file = read_example("richpeace_like.dxf", options);
  ASSERT_EQ(file.marker.shapes.size(), 1U);
  // The vertex (18, 8) lies half-way, along the outline, between (20, 4), which moves by (1, 0.25), and (14, 10), which
  // moves by (0.5, 0.5).
  const Vec expected{to_lattice(18.75 * 25.4, file.marker.resolution),
                     to_lattice(8.375 * 25.4, file.marker.resolution)};
  const Polygon& outline = file.marker.shapes[0].outline;
  EXPECT_NE(std::find(outline.begin(), outline.end(), expected), outline.end());
}

TEST(CloLike, GrainIsTurnedOntoTheStripAndOutlinesClosedByFlag) {
  const MarkerFile file = read_example("clo_like.dxf");
  EXPECT_EQ(file.marker.shapes.size(), 2U);
  EXPECT_DOUBLE_EQ(extent_of(file, "Body_Front_L").x, 640);
  EXPECT_DOUBLE_EQ(extent_of(file, "Body_Front_L").y, 320);
  EXPECT_TRUE(has_note(file, "turned by -90 degrees"));
  const auto drawn = annotations(file, "Body_Front_L");
  ASSERT_EQ(drawn.notches.size(), 1U);
  EXPECT_EQ(drawn.notches[0].angle, 180.0);  // 270 before the turn
  EXPECT_EQ(drawn.notches[0].depth, 7);
}

TEST(CloLike, RuleTableWithoutCommas) {
  ReadingOptions options;
  options.rules = test::example("clo_like.rul");
  const MarkerFile file = read_example("clo_like.dxf", options);
  EXPECT_EQ(file.marker.shapes.size(), 6U);
  EXPECT_NEAR(extent_of(file, "Body_Front_R/S").x, 640 * 0.98, 1e-6);
}

TEST(BrowzwearLike, MissingBlockAndCentimetresOfNotchesAreNoted) {
  const MarkerFile file = read_example("browzwear_like.dxf");
  EXPECT_EQ(file.marker.pieces.size(), 1U);
  EXPECT_TRUE(has_note(file, "\"CREW SLV_M\", which is not in the file"));
  EXPECT_TRUE(has_note(file, "read as centimetres"));
  EXPECT_EQ(annotations(file, "CREW FR").notches.at(0).depth, 7);
}

TEST(PolyPatternLike, PairsAreMirroredAboutTheGrain) {
  const MarkerFile file = read_example("polypattern_like.dxf");
  EXPECT_EQ(pieces_of(file, "FRONT"), 2U);
  EXPECT_EQ(pieces_of(file, "BACK"), 1U);
  std::size_t flipped = 0;
  for (const Piece& piece : file.marker.pieces) flipped += piece.orientation.flip;
  EXPECT_EQ(flipped, 2U);
  EXPECT_TRUE(is_valid(file.marker));
  const auto drawn = annotations(file, "FRONT");
  EXPECT_EQ(drawn.drills.size(), 1U);
  EXPECT_EQ(drawn.texts.size(), 1U);
}

TEST(Boundary, OpenRunsAreJoinedEitherWayRound) {
  const MarkerFile file = read_example("open_runs.dxf");
  ASSERT_EQ(file.marker.shapes.size(), 1U);
  EXPECT_EQ(file.marker.shapes[0].outline.size(), 5U);
  EXPECT_TRUE(has_note(file, "joined of 4 runs"));
}

TEST(Boundary, AWideGapIsRefusedWithItsLine) {
  std::string text = test::example("open_runs.dxf");
  const std::size_t at = text.find("200.0000");
  text.replace(text.find("0.0040", at), 6, "9.0000");
  const auto file = protocol::files::read_file(text);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kTooFewVertices);
  EXPECT_NE(file.error().message.find("9 mm apart"), std::string::npos) << file.error().message;
  EXPECT_TRUE(file.error().field.starts_with("/line/"));
}

TEST(Unit, CallerThenTextThenHeaderElseRefused) {
  std::string text = test::example("open_runs.dxf");
  ReadingOptions inches;
  inches.unit = protocol::trade::LengthUnit::kInch;
  EXPECT_NEAR(extent_of(*protocol::files::read_file(text, inches), "YOKE").x, 400 * 25.4, 1e-6);
  text.replace(text.find("Units: METRIC"), 13, "No unit here.");
  const auto refused = protocol::files::read_file(text);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kMissingField);
  EXPECT_EQ(refused.error().field, "/unit");
  const std::string header = "  2\nHEADER\n";
  text.insert(text.find(header) + header.size(), "  9\n$INSUNITS\n 70\n5\n");
  EXPECT_NEAR(extent_of(*protocol::files::read_file(text), "YOKE").x, 4000, 1e-6);
}

// The yoke's lower edge becomes a half circle of 200 inches; its chords lie 0.05 mm from it, not 0.05 inches.
TEST(Unit, IsThatOfTheToleranceToo) {
  std::string text = test::example("open_runs.dxf");
  const std::string corner = "VERTEX\n  8\n1\n 10\n0.0000\n 20\n0.0000\n";
  text.insert(text.find(corner) + corner.size(), " 42\n1\n");
  ReadingOptions inches;
  inches.unit = protocol::trade::LengthUnit::kInch;
  const double area = test::area_of(*protocol::files::read_file(text, inches), 0) / (25.4 * 25.4);
  EXPECT_NEAR(area, 400 * 150 + 400 * 30 / 2 + std::numbers::pi * 200 * 200 / 2, 2);
}

TEST(NoPattern, IsRefusedWithAReason) {
  const std::string text = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n5\n21\n5\n0\nENDSEC\n0\nEOF\n";
  const auto file = protocol::files::read_file(text);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kUnknownFormat);
  EXPECT_NE(file.error().message.find("layer 1"), std::string::npos);
}

TEST(NoPattern, BrokenTagsNameTheirLine) {
  const auto file = protocol::files::read_file("0\nSECTION\n2\nBLOCKS\nten\n0\n");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kSyntax);
  EXPECT_EQ(file.error().field, "/line/5");
}

TEST(Sizes, AnUnknownOneIsRefusedAndNamesTheOthers) {
  ReadingOptions options;
  options.sizes = {"99"};
  const auto file = protocol::files::read_file(test::example("accumark_like_nest.dxf"), options);
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("30, 32, 34"), std::string::npos);
}

struct RealPattern {
  const char *name, *rules;
  std::size_t shapes, pieces;
};
class RealPatterns : public testing::TestWithParam<RealPattern> {};

TEST_P(RealPatterns, AreReadAsTheyWereMeasured) {
  const std::string text = test::real_file(GetParam().name);
  if (text.empty()) GTEST_SKIP() << "SELVAGE_TRADE_DATA does not name the folder of real files";
  ReadingOptions options;
  if (*GetParam().rules) options.rules = test::real_file(GetParam().rules);
  const auto file = protocol::files::read_file(text, options);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->marker.shapes.size(), GetParam().shapes);
  EXPECT_EQ(file->marker.pieces.size(), GetParam().pieces);
  EXPECT_TRUE(is_valid(file->marker));
}

INSTANTIATE_TEST_SUITE_P(
    Trade, RealPatterns,
    testing::Values(RealPattern{"aama/Relaxed_Chino.dxf", "", 84, 140}, RealPattern{"aama/S350.dxf", "", 4, 5},
                    RealPattern{"aama/S350.dxf", "aama/S350.rul", 36, 45},
                    RealPattern{"aama/AMELIA_AZUL_prova.dxf", "", 4, 4},
                    RealPattern{"aama/AMELIA_AZUL_prova.dxf", "aama/AMELIA_AZUL_prova.rul", 20, 20},
                    RealPattern{"aama/Browzwear_T_Shirt_SS_CL_CREW_TEE.dxf", "", 4, 4}));

}  // namespace
}  // namespace selvage
