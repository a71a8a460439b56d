#include "protocol/formats/native.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "tests/protocol/formats/samples.h"

namespace selvage::protocol::formats {
namespace {

using test::json;
using test::native_squares;

TEST(Native, ReadsAMarker) {
  const MarkerFile file = test::read(native_squares());
  EXPECT_EQ(file.format, Format::kNative);
  EXPECT_EQ(file.marker.name, "two squares");
  EXPECT_EQ(file.marker.unit, "mm");
  EXPECT_EQ(to_decimal(file.marker.strip.width, file.marker.resolution), 100);
  ASSERT_EQ(file.marker.pieces.size(), 2u);
  EXPECT_EQ(file.marker.pieces[1].id, "right");
  EXPECT_EQ(to_decimal(file.marker.pieces[1].at.x, file.marker.resolution), 50);
  EXPECT_EQ(file.marker.shapes[0].rotations, std::vector{Angle{}});
  EXPECT_TRUE(file.notes.empty());
}

TEST(Native, RoundTripsUnplacedPieces) {
  Json document = native_squares();
  document["shapes"][0]["rotations"] = json("[0,90]");
  document["unplaced"] = json(R"([{"id": "spare", "shape": "square", "rotation": 90, "buffer": 0.5, "group": "pair",
                                   "attributes": {"bundle": "B"}}, {"id": 7, "shape": "square"}])");
  const MarkerFile once = test::read(document);
  ASSERT_EQ(once.marker.unplaced.size(), 2u);
  EXPECT_EQ(once.marker.pieces, test::read(native_squares()).marker.pieces);
  EXPECT_EQ(once.marker.unplaced[0].orientation.rotation, Angle::of_degrees(90));
  EXPECT_EQ(once.marker.unplaced[0].group, "pair");
  EXPECT_EQ(once.marker.unplaced[1].id, "7");
  EXPECT_EQ(length_of(once.marker), length_of(test::read(native_squares()).marker));

  const Json written = native_document(once);
  EXPECT_EQ(json::to_text(written["unplaced"][0]),
            R"({"id":"spare","shape":"square","rotation":90,"group":"pair","buffer":0.5,"attributes":{"bundle":"B"}})");
  EXPECT_EQ(test::read(written).marker, once.marker);
}

TEST(Native, ReadsAMarkerWithoutPlacedPieces) {
  Json document = native_squares();
  document["pieces"] = Json::array();
  document["unplaced"] = json(R"([{"id": "spare", "shape": "square"}])");
  const MarkerFile file = test::read(document);
  EXPECT_EQ(length_of(file.marker), 0);
  EXPECT_EQ(utilisation_of(file.marker), 0);
  EXPECT_TRUE(is_valid(file.marker));
}

TEST(Native, RoundTripsEverything) {
  Json document = native_squares();
  document["unit"] = "in";
  document["resolution"] = 1e-7;
  document["strip"]["longest"] = 400.5;
  document["spacing"] = 0.25;
  document["attributes"] = json(R"({"customer": {"no": 17}})");
  document["shapes"][0]["rotations"] = json("[0,90,180.5]");
  document["shapes"][0]["flip"] = true;
  document["shapes"][0]["tilt_limit"] = 3;
  document["shapes"][0]["attributes"] = json(R"({"name": "pocket", "size": 1.10})");
  document["pieces"][1]["rotation"] = 90;
  document["pieces"][1]["flip"] = true;
  document["pieces"][1]["tilt"] = -1.5;
  document["pieces"][0]["locked"] = json(R"(["x", "tilt"])");
  document["pieces"][0]["group"] = "pair";
  document["pieces"][0]["buffer"] = 0.125;
  document["overlap"] = 0.375;
  document["pieces"][1]["overlap"] = 0;
  document["strip"]["margin"] = 0.5;
  document["pieces"][1]["locked"] = true;
  document["pieces"][1]["at"] = json("[91.0000001, 50]");
  document["pieces"][1]["attributes"] = json(R"({"bundle": "A"})");
  const MarkerFile once = test::read(document);
  EXPECT_EQ(once.marker.resolution, Resolution{-7});
  EXPECT_TRUE(once.marker.pieces[1].locked);
  EXPECT_EQ(once.marker.pieces[0].locked, (Locks{true, false, true}));
  EXPECT_EQ(to_decimal(once.marker.pieces[0].buffer, once.marker.resolution), 0.125);
  EXPECT_EQ(to_decimal(once.marker.strip.margin, once.marker.resolution), 0.5);
  EXPECT_EQ(to_decimal(once.marker.overlap, once.marker.resolution), 0.375);
  EXPECT_FALSE(once.marker.pieces[0].overlap);
  EXPECT_EQ(once.marker.pieces[1].overlap, 0);

  const Json written = native_document(once);
  const MarkerFile twice = test::read(written);
  EXPECT_EQ(once.marker, twice.marker);
  EXPECT_EQ(json::to_text(written), json::to_text(native_document(twice)));
  EXPECT_EQ(json::to_text(written["pieces"][1]["at"]), "[91.0000001,50]");
  EXPECT_EQ(json::to_text(written["pieces"][0]["locked"]), R"(["x","tilt"])");
  EXPECT_EQ(written["pieces"][0]["group"], "pair");
  EXPECT_EQ(json::to_text(written["attributes"]), R"({"customer":{"no":17}})");
}

// A marker that uses no newer fields is written in the first version of this format, so that older programs can read
// it.
TEST(Native, WritesLaterFieldsOnlyWhereTheyAreUsed) {
  const std::vector<std::string_view> of_marker{"format", "version", "name",   "unit",  "resolution",
                                                "strip",  "spacing", "shapes", "pieces"};
  const std::vector<std::string_view> of_shape{"id", "outline", "rotations", "flip", "tilt_limit"};
  const std::vector<std::string_view> of_piece{"id", "shape", "at", "rotation"};
  const auto names = [](const Json& object) {
    std::vector<std::string_view> found;
    for (const auto& [name, value] : object.items()) found.push_back(name);
    return found;
  };
  const Json written = native_document(test::read(native_squares()));
  EXPECT_EQ(names(written), of_marker);
  EXPECT_EQ(names(written["strip"]), std::vector<std::string_view>{"width"});
  EXPECT_EQ(names(written["shapes"][0]), of_shape);
  EXPECT_EQ(names(written["pieces"][0]), of_piece);
}

TEST(Native, RefusesUnknownVersions) {
  Json document = native_squares();
  document["version"] = 2;
  const auto refused = read_document(document);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "/version");
}

TEST(Native, RoundsAllowancesDownAndNotesNarrowParts) {
  Json document = native_squares();
  document["resolution"] = 0.1;
  document["overlap"] = 1.49;
  document["shapes"][0]["outline"] = json("[[0,0],[40,0],[40,10],[60,10],[60,11],[40,11],[40,40],[0,40]]");
  document["pieces"][1]["at"] = json("[70,0]");
  const MarkerFile file = test::read(document);
  EXPECT_EQ(to_decimal(file.marker.overlap, file.marker.resolution), 1.4);
  const Note narrow{"/shapes/0/outline",
                    "has a part narrower than the overlap allowance of 1.4: another piece may lie over all of it"};
  EXPECT_EQ(std::count(file.notes.begin(), file.notes.end(), narrow), 1);
  document["overlap"] = 0.9;
  const auto notes = test::read(document).notes;
  EXPECT_TRUE(
      std::none_of(notes.begin(), notes.end(), [](const Note& note) { return note.field == "/shapes/0/outline"; }));
}

TEST(Native, KeepsClothsRules) {
  Json document = native_squares();
  document["strip"]["below"] = 1.5;
  document["strip"]["above"] = 0;
  document["shade"] = 95.25;
  document["strip"]["repeat"] = json(R"({"along": 12.5, "phase": [-3.25, 0]})");
  document["pieces"][0]["rules"] = json(R"({"below": 0, "to": 90.5, "match": [-3.25, 7], "shade": "S-A"})");
  document["pieces"][1]["rules"] = json(R"({"above": 2, "from": 1.25, "shade": "S-A"})");
  const MarkerFile file = test::read(document);
  const auto decimal = [&file](std::optional<Coord> coord) {
    return to_decimal(coord.value(), file.marker.resolution);
  };
  EXPECT_EQ(decimal(file.marker.strip.below), 1.5);
  EXPECT_EQ(file.marker.strip.above, 0);
  EXPECT_EQ(decimal(file.marker.shade), 95.25);
  EXPECT_EQ(file.marker.pieces[0].rules.below, 0);
  EXPECT_EQ(decimal(file.marker.pieces[0].rules.to), 90.5);
  EXPECT_EQ(file.marker.pieces[1].rules.shade, "S-A");
  EXPECT_EQ(decimal(file.marker.strip.repeat.along), 12.5);
  EXPECT_EQ(decimal(file.marker.pieces[0].rules.match.value().x), -3.25);
  const Json written = native_document(file);
  EXPECT_EQ(test::read(written).marker, file.marker);
  EXPECT_EQ(written["pieces"][0]["rules"], document["pieces"][0]["rules"]);
  EXPECT_FALSE(native_document(test::read(native_squares()))["pieces"][0].contains("rules"));
}

TEST(Native, RoundsRulesSoThatTheyHoldAsWritten) {
  Json document = native_squares();
  document["resolution"] = 0.1;
  document["strip"]["below"] = 0.01;
  document["shade"] = 95.29;
  document["pieces"][0]["rules"] = json(R"({"below": 0.01, "from": 0.01, "to": 90.59})");
  const Marker marker = test::read(document).marker;
  EXPECT_EQ(marker.strip.below, 1);
  EXPECT_EQ(marker.shade, 952);
  EXPECT_EQ(marker.pieces[0].rules, (marker::Rules{.below = 1, .from = 1, .to = 905}));
}

TEST(Native, ReportsTheInvalidRule) {
  const auto field_of = [](const std::string& rules) {
    Json document = native_squares();
    document["pieces"][1]["rules"] = json(rules);
    const auto file = read_native(document);
    return file ? std::string{} : file.error().field;
  };
  EXPECT_EQ(field_of(R"({"bellow": 1})"), "/pieces/1/rules/bellow");
  EXPECT_EQ(field_of(R"({"from": -1})"), "/pieces/1/rules/from");
  EXPECT_EQ(field_of(R"({"from": 10, "to": 20})"), "/pieces/1/rules/to");
  EXPECT_EQ(field_of(R"({"fold": 1})"), "/pieces/1/rules/fold");
  EXPECT_EQ(field_of(R"({"match": [1]})"), "/pieces/1/rules/match");
  EXPECT_EQ(field_of(R"({"matchSet": "A"})"), "/pieces/1/rules/matchSet");
  EXPECT_EQ(field_of(R"({"match": [1, 1], "matchSet": "A"})"), "");
  EXPECT_EQ(field_of(R"({"nap": "left"})"), "/pieces/1/rules/nap");
  EXPECT_EQ(field_of(R"({"nap": "down"})"), "/pieces/1/rules/nap");
  EXPECT_EQ(field_of(R"({"nap": "up"})"), "");
  EXPECT_EQ(field_of(R"({"zone": 1})"), "/pieces/1/rules/zone");
  EXPECT_EQ(field_of(R"({"zone": true, "to": 90})"), "/pieces/1/rules/zone");
  EXPECT_EQ(field_of(R"({"quality": 2})"), "");
  EXPECT_EQ(field_of(R"({"quality": 1.5})"), "/pieces/1/rules/quality");
  EXPECT_EQ(field_of(R"({"quality": 100})"), "/pieces/1/rules/quality");
  EXPECT_EQ(field_of(R"({"zone": true, "quality": 0})"), "/pieces/1/rules/quality");
  EXPECT_EQ(field_of(R"({"quality": 2, "part": {"outline": [[0, 0], [1, 0], [0, 1]]}})"), "");
  EXPECT_EQ(field_of(R"({"quality": 2, "part": {"outline": [[0, 0], [1, 0]]}})"), "/pieces/1/rules/part/outline");
  EXPECT_EQ(field_of(R"({"quality": 2, "part": {}})"), "/pieces/1/rules/part/outline");
  EXPECT_EQ(field_of(R"({"part": {"outline": [[0, 0], [1, 0], [0, 1]]}})"), "/pieces/1/rules/part/quality");
  EXPECT_EQ(field_of(R"([])"), "/pieces/1/rules");
}

TEST(Native, KeepsZones) {
  Json document = native_squares();
  document["pieces"][0]["rules"] =
      json(R"({"quality": 3, "part": {"outline": [[0, 0], [9.5, 0], [0, 9.5]], "quality": 1}})");
  document["pieces"][1]["rules"] = json(R"({"zone": true, "quality": 2})");
  const MarkerFile file = test::read(document);
  EXPECT_EQ(file.marker.pieces[0].rules.quality, 3);
  EXPECT_TRUE(file.marker.pieces[1].rules.zone);
  EXPECT_EQ(file.marker.pieces[1].rules.quality, 2);
  EXPECT_EQ(piece_count(file.marker), 1u);
  const Json written = native_document(file);
  EXPECT_EQ(test::read(written).marker, file.marker);
  for (const std::size_t k : {0U, 1U}) EXPECT_EQ(written["pieces"][k]["rules"], document["pieces"][k]["rules"]);
}

TEST(Native, KeepsTubes) {
  Json document = native_squares();
  document["strip"]["tube"] = true;
  const MarkerFile file = test::read(document);
  EXPECT_TRUE(file.marker.strip.tube);
  EXPECT_EQ(native_document(file)["strip"]["tube"], true);
  EXPECT_FALSE(native_document(test::read(native_squares()))["strip"].contains("tube"));
}

TEST(Native, ReadsWholeNumbersAsIds) {
  Json document = native_squares();
  document["shapes"][0]["id"] = 4;
  document["pieces"][0]["shape"] = 4;
  document["pieces"][1]["shape"] = "4";
  document["pieces"][0]["id"] = 17;
  const MarkerFile file = test::read(document);
  EXPECT_EQ(file.marker.shapes[0].id, "4");
  EXPECT_EQ(file.marker.pieces[0].id, "17");
}

TEST(Native, ReadsARotationAsTheEqualAllowedOne) {
  Json document = native_squares();
  document["shapes"][0]["rotations"] = json("[0, 270]");
  document["pieces"][1]["rotation"] = -90;
  document["pieces"][1]["at"] = json("[50, 50]");
  EXPECT_EQ(test::read(document).marker.pieces[1].orientation.rotation, Angle::of_degrees(270));
  document["shapes"][0]["rotations"] = "any";
  document["pieces"][1]["rotation"] = 90;
  document["pieces"][1]["at"] = json("[90, 50]");
  EXPECT_TRUE(test::read(document).marker.shapes[0].rotations.empty());
}

TEST(Native, ChoosesAResolutionThatHoldsEveryDecimal) {
  Json document = native_squares();
  document["pieces"][1]["at"] = json("[50.123456789, 10]");
  const MarkerFile file = test::read(document);
  EXPECT_LE(file.marker.resolution.exponent, -9);
  EXPECT_EQ(to_decimal(file.marker.pieces[1].at.x, file.marker.resolution), 50.123456789);
  EXPECT_TRUE(file.notes.empty());
}

TEST(Native, ReportsWhenDecimalsAreRounded) {
  Json document = native_squares();
  document["resolution"] = 0.01;
  document["pieces"][1]["at"] = json("[50.123, 10]");
  const MarkerFile file = test::read(document);
  EXPECT_EQ(to_decimal(file.marker.pieces[1].at.x, file.marker.resolution), 50.12);
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_EQ(file.notes[0].text, "coordinates are rounded to multiples of 0.01 mm");
}

TEST(Native, RepairsOutlinesAndReportsIt) {
  Json document = native_squares();
  // Clockwise, a repeated vertex, one on a straight edge, closed; and a hole.
  document["shapes"][0]["outline"] = json("[[0,0],[0,40],[0,40],[20,40],[40,40],[40,0],[0,0]]");
  document["shapes"][0]["holes"] = json("[[[10,10],[20,10],[20,20]]]");
  const MarkerFile file = test::read(document);
  EXPECT_EQ(file.marker.shapes[0].outline.size(), 4u);
  EXPECT_GT(doubled_area(file.marker.shapes[0].outline), 0);
  const std::vector<Note> expected{{"/shapes/0/outline", "1 repeated vertex left out"},
                                   {"/shapes/0/outline", "1 vertex on a straight edge left out"},
                                   {"/shapes/0/outline", "clockwise; turned round"},
                                   {"/shapes/0/holes", "1 hole is treated as filled, and kept as a cut-out"}};
  EXPECT_EQ(file.notes, expected);
}

TEST(Native, ReadsOverlappingAndProtrudingPiecesWithoutAnError) {
  Json document = native_squares();
  document["pieces"][1]["at"] = json("[20, 80]");
  EXPECT_FALSE(is_valid(test::read(document).marker));
}

TEST(Spacing, IsRoundedUpSoThatItHolds) {
  const auto file = with_spacing(test::read(native_squares()), 1.0 / 3.0);
  ASSERT_TRUE(file);
  EXPECT_GE(to_decimal(file->marker.spacing, file->marker.resolution), 1.0 / 3.0);
  ASSERT_EQ(file->notes.size(), 1u);
  for (const double bad : {-1.0, 101.0, std::numeric_limits<double>::quiet_NaN(), 1e308}) {
    const auto refused = with_spacing(test::read(native_squares()), bad);
    ASSERT_FALSE(refused) << bad;
    EXPECT_EQ(refused.error().code, ErrorCode::kOutOfRange);
    EXPECT_EQ(refused.error().field, "/spacing");
  }
}

}  // namespace
}  // namespace selvage::protocol::formats
