#include "protocol/codec.h"

#include <gtest/gtest.h>

#include "tests/protocol/samples.h"

namespace selvage {
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
  const auto plain = decode_motion_compact({{"markerId", "m1"}});
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->accuracy, Accuracy::kStandard);
  EXPECT_TRUE(plain->commit);
  EXPECT_FALSE(plain->timing);
  EXPECT_FALSE(plain->base_revision);
  const auto full = decode_motion_compact(
      json(R"({"markerId":"m1","baseRev":3,"accuracy":"fine","rounds":7,"commit":false,"timing":true})"));
  ASSERT_TRUE(full);
  EXPECT_EQ(full->base_revision, 3u);
  EXPECT_EQ(full->accuracy, Accuracy::kFine);
  EXPECT_EQ(full->rounds, 7);
  EXPECT_FALSE(full->commit);
  EXPECT_TRUE(full->timing);
}

TEST(Codec, RefusesUnknownParametersOfEveryMethod) {
  const Json params{{"markerId", "m1"}, {"extra", 1}};
  EXPECT_EQ(decode_marker_get(params).error().field, "/extra");
  EXPECT_EQ(decode_marker_check(params).error().field, "/extra");
  EXPECT_EQ(decode_marker_close(params).error().field, "/extra");
  EXPECT_EQ(decode_motion_compact(params).error().field, "/extra");
  EXPECT_EQ(decode_no_params({{"extra", 1}}).error().field, "/extra");
  EXPECT_EQ(decode_marker_open({{"marker", test::native_squares()}, {"extra", 1}}).error().field, "/extra");
}

TEST(Codec, ReadsTheFormatOfMarkerGet) {
  EXPECT_EQ(decode_marker_get({{"markerId", "m1"}})->format, Format::kNative);
  EXPECT_EQ(decode_marker_get({{"markerId", "m1"}, {"format", "svg"}})->format, Format::kSvg);
  EXPECT_EQ(decode_marker_get({{"markerId", "m1"}, {"format", "dxf"}}).error().field, "/format");
}

TEST(Codec, TellsTheFaultsOfAMarkerByIdAndInItsUnit) {
  Json document = test::native_squares();
  document["resolution"] = 1e-3;
  const Marker marker = test::read(document).marker;
  const Validity validity{.overlaps = {{PieceId{0}, PieceId{1}, 12345.5, 2000, 1500.25}},
                          .protrusions = {{PieceId{1}, 7}}};
  EXPECT_EQ(
      to_text(validity_json(marker, validity)),
      R"({"valid":false,"overlaps":[{"first":"left","second":"right","witness":[12.3455,2],"depth":1.50025}],)"
      R"("protrusions":[{"piece":"right","by":0.007}]})");
}

TEST(Codec, TellsOnlyThePlacementsThatChanged) {
  const Marker before = test::read(test::native_squares()).marker;
  Marker after = before;
  after.pieces[1].at.x = to_lattice(40.5, after.resolution);
  EXPECT_EQ(to_text(changed_placements(before, after)),
            R"([{"id":"right","at":[40.5,10],"rotation":0,"flip":false,"tilt":0}])");
  EXPECT_TRUE(changed_placements(before, before).empty());
}

TEST(Codec, TellsTimesOnlyWhenAsked) {
  MotionCompacted compacted;
  compacted.placements = Json::array();
  EXPECT_TRUE(encode(compacted).contains("ms"));
  compacted.timing = false;
  EXPECT_FALSE(encode(compacted).contains("ms"));
  EXPECT_FALSE(encode(compacted).contains("cache"));
}

TEST(Figures, AreProvedNotAssumed) {
  Compaction compaction;
  compaction.marker = test::read(test::native_squares()).marker;
  compaction.length_after = length_of(compaction.marker);
  EXPECT_TRUE(figures_of(compaction, {}, {}).valid);
  EXPECT_EQ(figures_of(compaction, {}, {}).length_after, 90);
  compaction.marker.pieces[1].at = {};
  EXPECT_FALSE(figures_of(compaction, {}, {}).valid);
}

}  // namespace
}  // namespace selvage
