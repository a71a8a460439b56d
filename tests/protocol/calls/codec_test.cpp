#include "protocol/calls/codec.h"

#include <gtest/gtest.h>

#include "protocol/methods/motions/bump.h"
#include "protocol/methods/motions/compact.h"
#include "protocol/methods/motions/push.h"
#include "protocol/methods/readings/reading.h"
#include "tests/protocol/formats/samples.h"

namespace selvage::protocol::calls {
namespace {

using test::json;

TEST(Codec, OpensAMarkerWithASpacing) {
  const auto open = decode_marker_open({{"marker", test::sparrow_squares()}, {"spacing", 1.5}});
  ASSERT_TRUE(open);
  EXPECT_EQ(to_decimal(open->file.marker.spacing, open->file.marker.resolution), 1.5);
}

TEST(Codec, NamesFieldsFromTheParameters) {
  Json marker = test::native_squares();
  marker["pieces"][0]["at"] = "here";
  const auto open = decode_marker_open({{"marker", marker}});
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().field, "/marker/pieces/0/at");
  const auto spaced = decode_marker_open({{"marker", test::native_squares()}, {"spacing", -1}});
  ASSERT_FALSE(spaced);
  EXPECT_EQ(spaced.error().field, "/spacing");

  marker = test::native_squares();
  marker["shapes"][0]["holes"] = json("[[[1,1],[2,1],[2,2]]]");
  EXPECT_EQ(decode_marker_open({{"marker", marker}})->file.notes[0].field, "/marker/shapes/0/holes");
}

TEST(Codec, DecodesACompaction) {
  const auto plain = methods::motions::decode_motion_compact({{"markerId", "m1"}});
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->effort.accuracy, motion::compaction::Accuracy::kStandard);
  EXPECT_TRUE(plain->call.commit);
  EXPECT_FALSE(plain->call.timing);
  EXPECT_FALSE(plain->call.base_revision);
  const auto full = methods::motions::decode_motion_compact(json(
      R"({"markerId":"m1","baseRev":3,"accuracy":"fine","rounds":7,"simplification":0.001,"commit":false,"timing":true})"));
  ASSERT_TRUE(full);
  EXPECT_EQ(full->call.base_revision, 3u);
  EXPECT_EQ(full->effort.accuracy, motion::compaction::Accuracy::kFine);
  EXPECT_EQ(full->effort.rounds, 7);
  EXPECT_EQ(full->effort.simplification, 0.001);
  EXPECT_FALSE(full->call.commit);
  EXPECT_TRUE(full->call.timing);
}

TEST(Codec, RefusesUnknownParametersOfEveryMethod) {
  const Json params{{"markerId", "m1"}, {"extra", 1}};
  EXPECT_EQ(methods::readings::decode_marker_get(params).error().field, "/extra");
  EXPECT_EQ(methods::readings::decode_marker_study(params).error().field, "/extra");
  EXPECT_EQ(decode_marker_close(params).error().field, "/extra");
  EXPECT_EQ(methods::motions::decode_motion_compact(params).error().field, "/extra");
  Json bump = params;
  bump.update(Json{{"piece", "a"}, {"direction", {1, 0}}});
  EXPECT_EQ(methods::motions::decode_motion_bump(bump).error().field, "/extra");
  Json gravity = params;
  gravity["force"] = {1, 0};
  EXPECT_EQ(methods::motions::decode_motion_gravity(gravity).error().field, "/extra");
  Json push = params;
  push["forces"] = json(R"([{"piece":"a","force":[1,0]}])");
  EXPECT_EQ(methods::motions::decode_motion_push(push).error().field, "/extra");
  EXPECT_EQ(decode_no_params({{"extra", 1}}).error().field, "/extra");
  EXPECT_EQ(decode_marker_open({{"marker", test::native_squares()}, {"extra", 1}}).error().field, "/extra");
}

TEST(Codec, ReadsTheFormatOfMarkerGet) {
  EXPECT_EQ(methods::readings::decode_marker_get({{"markerId", "m1"}})->format, Format::kNative);
  EXPECT_EQ(methods::readings::decode_marker_get({{"markerId", "m1"}, {"format", "svg"}})->format, Format::kSvg);
  EXPECT_EQ(methods::readings::decode_marker_get({{"markerId", "m1"}, {"format", "dxf"}}).error().field, "/format");
}

TEST(Codec, TellsTheFaultsOfAMarkerByIdAndInItsUnit) {
  Json document = test::native_squares();
  document["resolution"] = 1e-3;
  const Marker marker = test::read(document).marker;
  const marker::Validity validity{.overlaps = {{PieceId{0}, PieceId{1}, 12345.5, 2000, 1500.25}},
                                  .protrusions = {{PieceId{1}, 7}}};
  EXPECT_EQ(json::to_text(validity_json(marker, validity)),
            R"({"valid":false,"overlaps":[{"first":"left","second":"right","witness":[12.3455,2],"depth":1.50025}],)"
            R"("protrusions":[{"piece":"right","by":0.007}]})");
}

TEST(Codec, TellsOnlyThePlacementsThatChanged) {
  const Marker before = test::read(test::native_squares()).marker;
  Marker after = before;
  after.pieces[1].at.x = to_lattice(40.5, after.resolution);
  EXPECT_EQ(json::to_text(changed_placements(before, after)),
            R"([{"id":"right","at":[40.5,10],"rotation":0,"flip":false,"tilt":0}])");
  EXPECT_TRUE(changed_placements(before, before).empty());
}

TEST(Codec, DecodesForces) {
  const auto push = methods::motions::decode_motion_push(
      json(R"({"markerId":"m1","rounds":3,"forces":[{"piece":"a","force":[1,-2]},{"piece":7,"force":[0,0.5]}]})"));
  ASSERT_TRUE(push);
  ASSERT_EQ(push->forces.size(), 2u);
  EXPECT_EQ(push->forces[0].first, "a");
  EXPECT_EQ(push->forces[0].second.y, -2);
  EXPECT_EQ(push->forces[1].first, "7");  // ids are strings; whole numbers are read as their digits
  EXPECT_EQ(push->effort.rounds, 3);
  const auto gravity =
      methods::motions::decode_motion_gravity(json(R"({"markerId":"m1","force":[0,-1],"accuracy":"draft"})"));
  ASSERT_TRUE(gravity);
  EXPECT_EQ(gravity->force.y, -1);
  EXPECT_EQ(gravity->effort.accuracy, motion::compaction::Accuracy::kDraft);
}

TEST(Codec, DecodesABump) {
  const auto bump = methods::motions::decode_motion_bump(
      json(R"({"markerId":"m1","baseRev":2,"commit":false,"piece":"a","direction":[-1,1e-9]})"));
  ASSERT_TRUE(bump);
  EXPECT_EQ(bump->piece, "a");
  EXPECT_EQ(bump->direction.x, -1);
  EXPECT_EQ(bump->call.base_revision, 2u);
  EXPECT_FALSE(bump->call.commit);
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

TEST_P(BadDirections, AreNamedWhereverTheyStand) {
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
  expect(methods::motions::decode_motion_bump(bump).error(), "/direction");
  Json gravity = id;
  gravity["force"] = direction;
  expect(methods::motions::decode_motion_gravity(gravity).error(), "/force");
  Json push = id;
  push["forces"] = Json::array({{{"piece", "a"}, {"force", {1, 0}}}, {{"piece", "b"}, {"force", direction}}});
  expect(methods::motions::decode_motion_push(push).error(), "/forces/1/force");
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

TEST(Codec, RefusesForcesThatAreNone) {
  const auto error_of = [](const char* forces) {
    return methods::motions::decode_motion_push({{"markerId", "m1"}, {"forces", json(forces)}}).error();
  };
  EXPECT_EQ(error_of("[]").field, "/forces");
  EXPECT_NE(error_of("[]").message.find("1 to 100000"), std::string::npos);
  EXPECT_EQ(error_of("{}").field, "/forces");
  EXPECT_EQ(error_of("[3]").field, "/forces/0");
  EXPECT_EQ(error_of(R"([{"force":[1,0]}])").field, "/forces/0/piece");
  EXPECT_EQ(error_of(R"([{"piece":"a","force":[1,0],"at":0}])").field, "/forces/0/at");
  EXPECT_EQ(methods::motions::decode_motion_push({{"markerId", "m1"}}).error().code, ErrorCode::kMissingField);
}

}  // namespace
}  // namespace selvage::protocol::calls
