// Parameters decoded and results encoded, by the descriptors of the methods.
#include <gtest/gtest.h>

#include "protocol/calls/results.h"
#include "protocol/methods/daemon/markers.h"
#include "protocol/methods/method_table.h"
#include "tests/protocol/formats/samples.h"
#include "tests/support/repository.h"

namespace selvage::protocol::calls {
namespace {

using methods::find_method;
using methods::daemon::decode_open;
using test::json;

Error error_of(const char* method, const Json& params) {
  const auto read = find_method(method)->read(params);
  EXPECT_FALSE(read) << method;
  return read.error();
}
// The decoded parameters, encoded again with defaults filled in.
std::string understood(const char* method, const char* params) {
  const auto read = find_method(method)->canonical(json(params));
  return read ? json::to_text(*read) : read.error().message;
}

TEST(OpenParams, AcceptTheCommandLinesOptionsForFilesAndCloth) {
  const Json text = test::repository_text("examples/trade/accumark_like_nest.dxf");
  const auto open = decode_open({{"marker", text},
                                 {"sizes", {"32", 34}},
                                 {"fold", "lay"},
                                 {"width", 1200},
                                 {"tube", true},
                                 {"marginBelow", 7},
                                 {"shade", 900},
                                 {"repeatAlong", 64},
                                 {"napDirection", "up"},
                                 {"zones", test::json(R"([{"from": [900, 0], "to": [950, 1200], "quality": 3}])")},
                                 {"pieceRules", test::json(R"([{"shape": "FRONT/34", "rules": {"quality": 3}}])")},
                                 {"blocks", test::json(R"([{"shape": "FRONT/34", "left": 5}])")}});
  ASSERT_TRUE(open) << open.error().field << ": " << open.error().message;
  const Marker& marker = open->file.marker;
  EXPECT_EQ(marker.shapes.size(), 5U);  // BAND and FRONT in two sizes, and the zone
  EXPECT_TRUE(marker.strip.tube);
  EXPECT_TRUE(marker.strip.below && marker.strip.repeat.any() && marker.shade);
  EXPECT_EQ(marker.pieces.back().rules.quality, 3);
  EXPECT_TRUE(marker.pieces.back().rules.zone);
}

TEST(OpenParams, ErrorsOfClothPointAtTheParameterOrIntoTheMarker) {
  const auto refused = [](const char* name, const char* value) {
    return decode_open({{"marker", test::native_squares()}, {name, test::json(value)}}).error().field;
  };
  EXPECT_EQ(refused("zones", R"([{"from": [9, 0], "to": [5, 1]}])"), "/zones/0/to");
  EXPECT_EQ(refused("zones", R"([{"from": [0, 0], "to": [5, 1], "quality": 0}])"), "/zones/0/quality");
  EXPECT_EQ(refused("marginBelow", "150"), "/marker/strip/below");
  EXPECT_EQ(refused("pieceRules", R"([{"piece": "left", "rules": {"to": 1}}])"), "/marker/pieces/0/rules/to");
  EXPECT_EQ(refused("napDirection", R"("up_and_down")"), "/napDirection");
}

TEST(Codec, OpensAMarkerWithASpacing) {
  const auto open = decode_open({{"marker", test::sparrow_squares()}, {"spacing", 1.5}});
  ASSERT_TRUE(open);
  EXPECT_EQ(to_decimal(open->file.marker.spacing, open->file.marker.resolution), 1.5);
}

TEST(Codec, NamesFieldsFromTheParameters) {
  Json marker = test::native_squares();
  marker["pieces"][0]["at"] = "here";
  const auto open = decode_open({{"marker", marker}});
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().field, "/marker/pieces/0/at");
  const auto spaced = decode_open({{"marker", test::native_squares()}, {"spacing", -1}});
  ASSERT_FALSE(spaced);
  EXPECT_EQ(spaced.error().field, "/spacing");

  marker = test::native_squares();
  marker["shapes"][0]["holes"] = json("[[[1,1],[2,1],[2,2]]]");
  EXPECT_EQ(decode_open({{"marker", marker}})->file.notes[0].field, "/marker/shapes/0/holes");
}

TEST(Codec, DecodesACompaction) {
  const auto plain = find_method("motion.compact")->read({{"markerId", "m1"}});
  ASSERT_TRUE(plain);
  EXPECT_TRUE(plain->about.commit);
  EXPECT_FALSE(plain->about.timing);
  EXPECT_FALSE(plain->about.base_revision);
  EXPECT_EQ(understood("motion.compact", R"({"markerId":"m1"})"),
            R"({"markerId":"m1","commit":true,"timing":false,"accuracy":"standard"})");
  const char* full =
      R"({"markerId":"m1","baseRev":3,"commit":false,"timing":true,"accuracy":"fine","rounds":7,"simplification":0.001})";
  const auto read = find_method("motion.compact")->read(json(full));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->about.base_revision, 3u);
  EXPECT_FALSE(read->about.commit);
  EXPECT_TRUE(read->about.timing);
  EXPECT_EQ(understood("motion.compact", full), full);
}

TEST(Codec, KnowsTheLaneOfACall) {
  const auto motion = find_method("motion.compact")->read({{"markerId", "m1"}, {"opId", "a"}});
  EXPECT_EQ(motion->lane(), "m1");
  EXPECT_TRUE(motion->bounded());
  const auto close = find_method("marker.close")->read({{"markerId", "m1"}, {"opId", "a"}});
  EXPECT_EQ(close->lane(), "a");  // retries of one call run one after another
  EXPECT_FALSE(close->bounded());
  EXPECT_EQ(find_method("marker.check")->read({{"markerId", "m1"}})->lane(), "");
}

TEST(Codec, RefusesUnknownParametersOfEveryMethod) {
  const Json params{{"markerId", "m1"}, {"extra", 1}};
  for (const char* method : {"marker.get", "marker.check", "marker.close", "motion.compact"}) {
    EXPECT_EQ(error_of(method, params).field, "/extra") << method;
  }
  Json bump = params;
  bump.update(Json{{"piece", "a"}, {"direction", {1, 0}}});
  EXPECT_EQ(error_of("motion.bump", bump).field, "/extra");
  Json gravity = params;
  gravity["force"] = {1, 0};
  EXPECT_EQ(error_of("motion.gravity", gravity).field, "/extra");
  Json push = params;
  push["forces"] = json(R"([{"piece":"a","force":[1,0]}])");
  EXPECT_EQ(error_of("motion.push", push).field, "/extra");
  EXPECT_EQ(error_of("engine.info", {{"extra", 1}}).field, "/extra");
  EXPECT_EQ(decode_open({{"marker", test::native_squares()}, {"extra", 1}}).error().field, "/extra");
}

TEST(Codec, ReadsTheFormatOfMarkerGet) {
  EXPECT_EQ(understood("marker.get", R"({"markerId":"m1"})"), R"({"markerId":"m1","format":"native"})");
  EXPECT_EQ(understood("marker.get", R"({"markerId":"m1","format":"svg"})"), R"({"markerId":"m1","format":"svg"})");
  EXPECT_EQ(error_of("marker.get", {{"markerId", "m1"}, {"format", "docx"}}).field, "/format");
}

TEST(Codec, NamesOverlapsByIdAndInTheMarkersUnit) {
  Json document = test::native_squares();
  document["resolution"] = 1e-3;
  const Marker marker = test::read(document).marker;
  const auto overlaps = overlaps_of(marker, {{PieceId{0}, PieceId{1}, 12345.5, 2000, 1500.25}});
  EXPECT_EQ(json::to_text(schema::Wire<std::vector<Overlap>>::write(overlaps)),
            R"([{"first":"left","second":"right","witness":[12.3455,2],"depth":1.50025}])");
  const auto protrusions = protrusions_of(marker, {{PieceId{1}, 7}});
  EXPECT_EQ(json::to_text(schema::Wire<std::vector<Protrusion>>::write(protrusions)),
            R"([{"piece":"right","by":0.007}])");
}

TEST(Codec, ListsOnlyThePlacementsThatChanged) {
  const Marker before = test::read(test::native_squares()).marker;
  Marker after = before;
  after.pieces[1].at.x = to_lattice(40.5, after.resolution);
  EXPECT_EQ(json::to_text(schema::Wire<std::vector<Placement>>::write(changed_placements(before, after))),
            R"([{"id":"right","at":[40.5,10],"rotation":0,"flip":false,"tilt":0}])");
  EXPECT_TRUE(changed_placements(before, before).empty());
}

TEST(Codec, DecodesForces) {
  // Ids are strings; whole numbers are read as their digits.
  EXPECT_EQ(
      understood("motion.push",
                 R"({"markerId":"m1","rounds":3,"forces":[{"piece":"a","force":[1,-2]},{"piece":7,"force":[0,0.5]}]})"),
      R"({"markerId":"m1","commit":true,"timing":false,"forces":[{"piece":"a","force":[1,-2]},)"
      R"({"piece":"7","force":[0,0.5]}],"accuracy":"standard","rounds":3})");
  EXPECT_EQ(understood("motion.gravity", R"({"markerId":"m1","force":[0,-1],"accuracy":"draft"})"),
            R"({"markerId":"m1","commit":true,"timing":false,"force":[0,-1],"accuracy":"draft"})");
}

TEST(Codec, DecodesABump) {
  EXPECT_EQ(
      understood("motion.bump", R"({"markerId":"m1","baseRev":2,"commit":false,"piece":"a","direction":[-1,1e-9]})"),
      R"({"markerId":"m1","baseRev":2,"commit":false,"timing":false,"piece":"a","direction":[-1,1e-09]})");
}

struct BadDirection {
  const char* value;
  ErrorCode code;
  const char* field;
  const char* says;
};
void PrintTo(const BadDirection& bad, std::ostream* out) {
  *out << bad.value;
}

class BadDirections : public testing::TestWithParam<BadDirection> {};

TEST_P(BadDirections, AreReportedWithTheirField) {
  const BadDirection& bad = GetParam();
  const auto expect = [&bad](const Error& error, const std::string& at) {
    EXPECT_EQ(error.code, bad.code) << error.message;
    EXPECT_EQ(error.field, at + bad.field);
    EXPECT_NE(error.message.find(bad.says), std::string::npos) << error.message;
  };
  const Json direction = json(bad.value);
  const Json id{{"markerId", "m1"}};
  Json bump = id;
  bump.update(Json{{"piece", "a"}, {"direction", direction}});
  expect(error_of("motion.bump", bump), "/direction");
  Json gravity = id;
  gravity["force"] = direction;
  expect(error_of("motion.gravity", gravity), "/force");
  Json push = id;
  push["forces"] = Json::array({{{"piece", "a"}, {"force", {1, 0}}}, {{"piece", "b"}, {"force", direction}}});
  expect(error_of("motion.push", push), "/forces/1/force");
}

INSTANTIATE_TEST_SUITE_P(All, BadDirections,
                         testing::Values(BadDirection{"[0, 0]", ErrorCode::kOutOfRange, "", "at least 1e-09"},
                                         BadDirection{"[-0.0, 5e-324]", ErrorCode::kOutOfRange, "", "is allowed"},
                                         BadDirection{"[1e300, 0]", ErrorCode::kOutOfRange, "/0",
                                                      "-1000000000 to 1000000000 is allowed"},
                                         BadDirection{"[0, null]", ErrorCode::kWrongType, "/1", "a number is required"},
                                         BadDirection{"[1]", ErrorCode::kWrongType, "", "[x, y] is required"},
                                         BadDirection{"[1, 2, 3]", ErrorCode::kWrongType, "", "[x, y] is required"},
                                         BadDirection{R"("left")", ErrorCode::kWrongType, "", "an array is required"}));

TEST(Codec, RefusesInvalidForces) {
  const auto error_of = [](const char* forces) {
    return calls::error_of("motion.push", {{"markerId", "m1"}, {"forces", json(forces)}});
  };
  EXPECT_EQ(error_of("[]").field, "/forces");
  EXPECT_NE(error_of("[]").message.find("1 to 100000"), std::string::npos);
  EXPECT_EQ(error_of("{}").field, "/forces");
  EXPECT_EQ(error_of("[3]").field, "/forces/0");
  EXPECT_EQ(error_of(R"([{"force":[1,0]}])").field, "/forces/0/piece");
  EXPECT_EQ(error_of(R"([{"piece":"a","force":[1,0],"at":0}])").field, "/forces/0/at");
  EXPECT_EQ(calls::error_of("motion.push", {{"markerId", "m1"}}).code, ErrorCode::kMissingField);
}

}  // namespace
}  // namespace selvage::protocol::calls
