#include "protocol/formats/sparrow.h"

#include <gtest/gtest.h>

#include "tests/protocol/formats/samples.h"

namespace selvage::protocol::formats {
namespace {

using test::json;
using test::sparrow_squares;

Json& placed(Json& document) {
  return document["solution"]["layout"]["placed_items"];
}

TEST(Sparrow, ReadsASolution) {
  const MarkerFile file = test::read(sparrow_squares());
  EXPECT_EQ(file.format, Format::kSparrow);
  EXPECT_EQ(to_decimal(file.marker.strip.width, file.marker.resolution), 100);
  ASSERT_EQ(file.marker.pieces.size(), 2u);
  EXPECT_EQ(file.marker.shapes[0].id, "7");
  EXPECT_EQ(file.marker.shapes[0].outline.size(), 4u);
  EXPECT_EQ(file.marker.pieces[0].id, "0");
  EXPECT_EQ(to_decimal(length_of(file.marker), file.marker.resolution), 90);
  EXPECT_TRUE(file.notes.empty());
}

TEST(Sparrow, ReadsAnInstanceAsUnplacedPieces) {
  Json document = sparrow_squares();
  document.erase("solution");
  document["items"][0]["demand"] = 3;
  document["items"][0]["allowed_orientations"] = json("[180, 0]");
  const MarkerFile file = test::read(document);
  EXPECT_TRUE(file.marker.pieces.empty());
  ASSERT_EQ(file.marker.unplaced.size(), 3u);
  EXPECT_EQ(file.marker.unplaced[2].id, "2");
  EXPECT_EQ(file.marker.unplaced[2].orientation.rotation, Angle::of_degrees(180));
  const auto written = sparrow_document(file);
  ASSERT_TRUE(written);
  EXPECT_FALSE(written->contains("solution"));
  EXPECT_EQ(test::read(*written).marker, file.marker);
}

TEST(Sparrow, ReadsUnmetDemandAsUnplacedPieces) {
  Json document = sparrow_squares();
  document["items"][0]["demand"] = 4;
  placed(document)[0]["id"] = "2";
  const MarkerFile file = test::read(document);
  EXPECT_EQ(file.marker.pieces.size(), 2u);
  ASSERT_EQ(file.marker.unplaced.size(), 2u);
  EXPECT_EQ(file.marker.unplaced[0].id, "0");  // "1" and "2" are taken
  EXPECT_EQ(file.marker.unplaced[1].id, "3");
  const auto written = sparrow_document(file);
  ASSERT_TRUE(written);
  EXPECT_EQ((*written)["items"][0]["demand"], 4);
  EXPECT_EQ(test::read(*written).marker, file.marker);
}

// A zone is a part of the cloth, not a copy of an item.
TEST(Sparrow, DemandDoesNotIncludeZones) {
  Json document = sparrow_squares();
  placed(document)[1]["rules"] = json(R"({"zone": true})");
  document["items"][0]["demand"] = 2;
  const MarkerFile file = test::read(document);
  EXPECT_EQ(file.marker.pieces.size(), 2U);
  ASSERT_EQ(file.marker.unplaced.size(), 1U);
  const auto written = sparrow_document(file);
  ASSERT_TRUE(written);
  EXPECT_EQ((*written)["items"][0]["demand"], 2);
  EXPECT_EQ(test::read(*written).marker, file.marker);
}

TEST(Sparrow, KeepsTubesAndQualities) {
  Json document = sparrow_squares();
  document["tube"] = true;
  placed(document)[0]["rules"] = json(R"({"fold": true, "quality": 1, "part": {"outline": [[0, 0], [5, 0], [0, 5]]}})");
  placed(document)[1]["rules"] = json(R"({"zone": true, "quality": 1})");
  const MarkerFile file = test::read(document);
  EXPECT_TRUE(file.marker.strip.tube);
  EXPECT_EQ(file.marker.pieces[1].rules.quality, 1);
  const auto written = sparrow_document(file);
  ASSERT_TRUE(written);
  EXPECT_EQ((*written)["tube"], true);
  EXPECT_EQ(test::read(*written).marker, file.marker);
}

TEST(Sparrow, KeepsUnknownFields) {
  Json document = sparrow_squares();
  document["description"] = "two";
  document["items"][0]["grain"] = "along +x";
  document["items"][0]["mirror_of"] = nullptr;
  document["items"][0]["tilt_limit_deg"] = 3;
  placed(document)[1]["operator"] = json(R"({"by": 4})");
  const auto written = sparrow_document(test::read(document));
  ASSERT_TRUE(written);
  EXPECT_EQ((*written)["description"], "two");
  EXPECT_EQ((*written)["items"][0]["grain"], "along +x");
  EXPECT_TRUE((*written)["items"][0]["mirror_of"].is_null());
  EXPECT_EQ((*written)["items"][0]["tilt_limit_deg"], 3);
  EXPECT_EQ((*written)["items"][0]["demand"], 2);
  EXPECT_EQ((*written)["items"][0]["id"], 7);
  EXPECT_EQ((*written)["solution"]["layout"]["placed_items"][1]["operator"], json(R"({"by": 4})"));
  EXPECT_EQ(test::read(*written).marker, test::read(document).marker);
}

TEST(Sparrow, WritesTheLengthAndDensityItHas) {
  Json document = sparrow_squares();
  document["solution"]["strip_width"] = 1234;
  const auto written = sparrow_document(test::read(document));
  ASSERT_TRUE(written);
  EXPECT_EQ((*written)["solution"]["strip_width"], 90);
  EXPECT_DOUBLE_EQ((*written)["solution"]["density"].get<double>(), 3200.0 / 9000.0);
}

TEST(Sparrow, RecognisesRadians) {
  Json document = sparrow_squares();
  placed(document)[1]["transformation"] = json(R"({"rotation": -3.1415927, "translation": [90, 50]})");
  const MarkerFile file = test::read(document);
  EXPECT_EQ(file.marker.pieces[1].orientation.rotation, Angle::of_degrees(180));
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_EQ(file.notes[0].text, "rotations are read as radians");
}

TEST(Sparrow, MatchesSinglePrecisionDegreesToAllowedRotations) {
  Json document = sparrow_squares();
  placed(document)[1]["transformation"] = json(R"({"rotation": -180.00002, "translation": [90, 50]})");
  EXPECT_EQ(test::read(document).marker.pieces[1].orientation.rotation, Angle::of_degrees(180));
}

TEST(Sparrow, ReadsATiltWithinTheLimit) {
  Json document = sparrow_squares();
  document["items"][0]["tilt_limit_deg"] = 3;
  placed(document)[1]["transformation"] = json(R"({"rotation": 182.5, "translation": [95, 55]})");
  const MarkerFile file = test::read(document);
  EXPECT_EQ(file.marker.pieces[1].orientation.rotation, Angle::of_degrees(180));
  EXPECT_EQ(file.marker.pieces[1].orientation.tilt, Angle::of_degrees(2.5));
  const auto written = sparrow_document(file);
  EXPECT_EQ((*written)["solution"]["layout"]["placed_items"][1]["transformation"]["rotation"], 182.5);
}

// Also tilts that are smaller than the tolerance for allowed rotations, because the pieces may touch.
TEST(Sparrow, ReadsTiltsBackExactly) {
  Json document = sparrow_squares();
  document["items"][0]["tilt_limit_deg"] = 3;
  MarkerFile file = test::read(document);
  for (const double tilt : {-0.000999995743522192, 1e-9, -2.9999999998695728, 0.1 + 0.2, 2.5}) {
    for (const double rotation : {0.0, 180.0}) {
      file.marker.pieces[0].orientation = {.rotation = Angle::of_degrees(rotation), .tilt = Angle::of_degrees(tilt)};
      const auto written = sparrow_document(file);
      ASSERT_TRUE(written);
      EXPECT_EQ(test::read(*written).marker.pieces[0].orientation, file.marker.pieces[0].orientation) << tilt;
    }
  }
}

TEST(Sparrow, ARotationThatContradictsItsTiltTakesPrecedence) {
  Json document = sparrow_squares();
  document["items"][0]["tilt_limit_deg"] = 3;
  placed(document)[1]["tilt_deg"] = 1;
  placed(document)[1]["transformation"] = json(R"({"rotation": 182.5, "translation": [95, 55]})");
  EXPECT_EQ(test::read(document).marker.pieces[1].orientation.tilt, Angle::of_degrees(2.5));
}

TEST(Sparrow, ReadsOrientationPermissionsAsJaguaDoes) {
  Json document = sparrow_squares();
  document["items"][0].erase("allowed_orientations");
  EXPECT_TRUE(test::read(document).marker.shapes[0].rotations.empty());
  document["items"][0]["allowed_orientations"] = Json::array();
  EXPECT_EQ(test::read(document).marker.shapes[0].rotations, std::vector{Angle{}});
}

TEST(Sparrow, IgnoresWholeTurns) {
  Json document = sparrow_squares();
  document["items"][0].erase("allowed_orientations");
  placed(document)[1]["transformation"] = json(R"({"rotation": 810, "translation": [90, 10]})");
  EXPECT_EQ(test::read(document).marker.pieces[1].orientation.rotation, Angle::of_degrees(90));
}

TEST(Sparrow, ReadsPolygonsWithHolesAsFilled) {
  Json document = sparrow_squares();
  document["items"][0]["shape"] = json(R"({"type": "polygon", "data": {
    "outer": [[0, 0], [0, 40], [40, 40], [40, 0]], "inner": [[[10, 10], [20, 10], [20, 20]]]}})");
  const MarkerFile file = test::read(document);
  EXPECT_EQ(file.marker.shapes[0].outline.size(), 4u);
  const std::vector<Note> expected{{"/items/0/shape/data/outer", "clockwise; turned round"},
                                   {"/items/0/shape/data/inner", "1 hole is treated as filled, and kept as a cut-out"}};
  EXPECT_EQ(file.notes, expected);
}

TEST(Sparrow, CarriesIdsLocksAndSpacingOfANativeMarker) {
  Json native = test::native_squares();
  native["spacing"] = 2.5;
  native["overlap"] = 0.75;
  native["pieces"][1]["locked"] = true;
  native["pieces"][0].update(json(R"({"locked": ["y"], "group": "g", "buffer": 0.5, "overlap": 0.25,
      "rules": {"above": 0.5, "from": 0, "match": [1, 2], "nap": "up", "shade": "A"}})"));
  native["strip"]["below"] = 0;
  native["strip"]["repeat"] = json(R"({"along": 1, "across": 0.5})");
  native["shade"] = 500;
  native["shapes"][0]["attributes"] = json(R"({"size": 38})");
  const MarkerFile file = test::read(native);
  const auto written = sparrow_document(file);
  ASSERT_TRUE(written);
  EXPECT_EQ((*written)["items"][0]["id"], 0);
  EXPECT_EQ((*written)["items"][0]["name"], "square");
  EXPECT_EQ((*written)["items"][0]["size"], 38);
  const MarkerFile back = test::read(*written);
  EXPECT_EQ(back.marker.pieces[1].id, "right");
  EXPECT_TRUE(back.marker.pieces[1].locked);
  EXPECT_EQ(back.marker.pieces[0].locked, (Locks{false, true, false}));
  EXPECT_EQ(back.marker.pieces[0].group, "g");
  EXPECT_EQ(to_decimal(back.marker.pieces[0].buffer, back.marker.resolution), 0.5);
  EXPECT_EQ(to_decimal(back.marker.spacing, back.marker.resolution), 2.5);
  EXPECT_EQ(to_decimal(back.marker.overlap, back.marker.resolution), 0.75);
  EXPECT_EQ(to_decimal(back.marker.pieces[0].overlap.value(), back.marker.resolution), 0.25);
  EXPECT_EQ(back.marker.pieces[0].rules, file.marker.pieces[0].rules);
  EXPECT_EQ(back.marker.strip, file.marker.strip);
  EXPECT_EQ(back.marker.shade, file.marker.shade);
}

TEST(Sparrow, KeepsAResolutionThatItsReaderWouldNotChoose) {
  Json native = test::native_squares();
  native["shapes"][0]["rotations"] = json("[30, 210]");
  for (const std::size_t piece : {0, 1}) native["pieces"][piece]["rotation"] = 30;
  native["pieces"][0]["at"] = json("[20, 0]");
  native["pieces"][1]["at"] = json("[54.64, 20]");
  for (const char* resolution : {"0.01", "1e-8"}) {
    native["resolution"] = json(resolution);
    const MarkerFile file = test::read(native);
    const auto written = sparrow_document(file);
    ASSERT_TRUE(written);
    EXPECT_EQ((*written)["resolution"], json(resolution));
    const MarkerFile back = test::read(*written);
    EXPECT_EQ(back.marker.resolution, file.marker.resolution);
    for (const PieceId piece : {PieceId{0}, PieceId{1}}) {
      EXPECT_EQ(placed_outline(back.marker, piece), placed_outline(file.marker, piece));
    }
    EXPECT_EQ(*sparrow_document(back), *written);
  }
  native["resolution"] = 1e-7;  // as it would be chosen
  EXPECT_EQ(sparrow_document(test::read(native))->find("resolution"), nullptr);
}

TEST(Sparrow, CannotExpressAFlippedPiece) {
  Json native = test::native_squares();
  native["shapes"][0]["flip"] = true;
  native["pieces"][0]["flip"] = true;
  native["pieces"][0]["at"] = json("[0, 40]");
  const auto written = sparrow_document(test::read(native));
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kOrientationNotAllowed);
  EXPECT_EQ(written.error().field, "/pieces/0/flip");
}

}  // namespace
}  // namespace selvage::protocol::formats
