// Tests of protocol/formats/jagua/bins.h, and of reading instances of bins as markers.
#include "protocol/formats/jagua/bins.h"

#include <gtest/gtest.h>

#include "protocol/formats/format.h"
#include "protocol/json/json_text.h"

namespace selvage::protocol::formats {
namespace {

constexpr std::string_view kInstance = R"({
  "name": "hides",
  "items": [
    {"id": 0, "demand": 2, "allowed_orientations": [0.0], "min_quality": null,
     "shape": {"type": "simple_polygon", "data": [[0, 0], [10, 0], [10, 5], [0, 5]]}},
    {"id": 1, "demand": 1, "allowed_orientations": [0.0], "min_quality": 7,
     "shape": {"type": "simple_polygon", "data": [[0, 0], [8, 0], [8, 8], [0, 8]]}}],
  "bins": [
    {"id": 0, "cost": 7, "stock": 3, "shape": {"type": "rectangle", "data": {"x_min": 5, "y_min": -2, "width": 30, "height": 20}}},
    {"id": 1, "cost": 1, "stock": 0, "shape": {"type": "rectangle", "data": {"x_min": 0, "y_min": 0, "width": 99, "height": 99}}},
    {"id": 2, "stock": 1e18,
     "shape": {"type": "polygon", "data": {"outer": [[0, 0], [60, 0], [30, 50]], "inner": [[[25, 5], [30, 5], [30, 10]]]}},
     "zones": [{"quality": 0, "shape": {"type": "simple_polygon", "data": [[1, 1], [5, 1], [5, 2]]}},
               {"quality": 8, "shape": {"type": "simple_polygon", "data": [[40, 1], [50, 1], [50, 9]]}},
               {"quality": 10, "shape": {"type": "simple_polygon", "data": [[7, 1], [9, 1], [9, 2]]}}]}]})";

Json instance() {
  return Json::parse(kInstance);
}

TEST(Bins, AreReadWithHolesZonesAndStock) {
  const auto bins = jagua::read_bins(instance()["bins"]);
  ASSERT_TRUE(bins);
  ASSERT_EQ(bins->size(), 2u);  // one is out of stock
  const jagua::Bin& rectangle = bins->front();
  EXPECT_EQ(rectangle.rectangle, (document::Spot{30, 20}));
  EXPECT_EQ(rectangle.count, 3u);
  EXPECT_EQ(rectangle.cost, 7);
  EXPECT_EQ(rectangle.outline.corners, (std::vector<document::Spot>{{5, -2}, {35, -2}, {35, 18}, {5, 18}}));
  const jagua::Bin& hide = bins->back();
  EXPECT_EQ(hide.rectangle, std::nullopt);
  EXPECT_EQ(hide.count, 1'000u);
  EXPECT_EQ(hide.cost, 1);
  EXPECT_EQ(hide.outline.field, "/bins/2/shape/data/outer");
  ASSERT_EQ(hide.zones.size(), 3u);
  EXPECT_EQ(hide.zones[0].outline.field, "/bins/2/shape/data/inner/0");
  EXPECT_EQ(hide.zones[0].quality, std::nullopt);
  EXPECT_EQ(hide.zones[1].outline.field, "/bins/2/zones/0/shape/data");
  EXPECT_EQ(hide.zones[1].quality, std::nullopt);
  EXPECT_EQ(hide.zones[2].quality, 2);
  EXPECT_EQ(jagua::widest(*bins), 50);
}

TEST(Bins, AnItemAcceptsWhatItNeedsAndBetter) {
  const auto file = read_document(instance());
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(to_decimal(file->marker.strip.width, file->marker.resolution), 50);
  ASSERT_EQ(file->marker.unplaced.size(), 3u);
  EXPECT_EQ(file->marker.unplaced[0].rules.quality, std::nullopt);
  EXPECT_EQ(file->marker.unplaced[1].rules.quality, std::nullopt);
  EXPECT_EQ(file->marker.unplaced[2].rules.quality, 3);  // a zone of quality 7 has class 3, one of quality 6 class 4
  ASSERT_EQ(file->notes.size(), 1u);
  EXPECT_EQ(file->notes[0].field, "/bins");
}

TEST(Bins, StayInTheFile) {
  const auto file = read_document(instance());
  ASSERT_TRUE(file);
  for (const Format format : {Format::kSparrow, Format::kNative}) {
    const auto written = marker_document(*file, format);
    ASSERT_TRUE(written);
    const auto again = read_document(*written);
    ASSERT_TRUE(again) << again.error().field << " " << again.error().message;
    EXPECT_EQ(again->attributes.whole["bins"], instance()["bins"]);
    EXPECT_EQ(again->marker.strip.width, file->marker.strip.width);
    ASSERT_EQ(again->marker.unplaced.size(), 3u);
    EXPECT_EQ(again->marker.unplaced[2].rules.quality, 3);
  }
}

TEST(Bins, NullsCountAsAbsent) {
  Json document = instance();
  document["solution"] = nullptr;
  document["items"][0]["allowed_orientations"] = nullptr;
  document["bins"][0]["stock"] = nullptr;
  document["bins"][2]["zones"] = nullptr;
  const auto file = read_document(document);
  ASSERT_TRUE(file) << file.error().field << " " << file.error().message;
  EXPECT_TRUE(file->marker.shapes[0].rotations.empty());  // any
}

TEST(Bins, MistakesAreNamedWithTheirField) {
  struct Case {
    std::string pointer;
    Json value;
    std::string field;
  };
  const std::vector<Case> cases{
      {"shape", nullptr, "/bins/0/shape"},
      {"shape", {{"type", "multi_polygon"}, {"data", Json::array()}}, "/bins/0/shape/type"},
      {"shape", {{"type", "simple_polygon"}, {"data", {1, 2}}}, "/bins/0/shape/data/0"},
      {"shape", {{"type", "simple_polygon"}, {"data", Json::array({Json::array({"a", 2})})}}, "/bins/0/shape/data/0/0"},
      {"stock", "many", "/bins/0/stock"},
      {"stock", 1.5, "/bins/0/stock"},
      {"cost", -1, "/bins/0/cost"},
      {"zones", Json::array({Json::object({{"shape", Json::object()}})}), "/bins/0/zones/0/quality"},
  };
  for (const Case& wrong : cases) {
    Json document = instance();
    document["bins"][0][wrong.pointer] = wrong.value;
    const auto file = read_document(document);
    ASSERT_FALSE(file) << wrong.field;
    EXPECT_EQ(file.error().field, wrong.field) << file.error().message;
  }
  Json empty = instance();
  empty["bins"] = Json::array();
  EXPECT_EQ(read_document(empty).error().field, "/bins");
  Json solved = instance();
  solved["solution"] = {{"layouts", Json::array()}};
  EXPECT_EQ(read_document(solved).error().field, "/solution/layouts");
  Json endless = instance();
  endless["items"][1].erase("demand");
  EXPECT_EQ(read_document(endless).error().field, "/items/1/demand");
  Json holed = instance();
  Json& shape = holed["bins"][2]["shape"];
  for (int k = 0; k < 1'000; ++k) shape["data"]["inner"].push_back(shape["data"]["inner"][0]);
  EXPECT_EQ(read_document(holed).error().field, "/bins/2");
}

}  // namespace
}  // namespace selvage::protocol::formats
