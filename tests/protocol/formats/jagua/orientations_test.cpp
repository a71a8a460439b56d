// Tests of protocol/formats/jagua/orientations.h, and of items with the permissions of jagua-rs 0.9.
#include "protocol/formats/jagua/orientations.h"

#include <gtest/gtest.h>

#include "protocol/formats/format.h"
#include "protocol/json/json_text.h"

namespace selvage::protocol::formats {
namespace {

Json instance(std::string_view orientation) {
  Json document = Json::parse(R"({
    "name": "steps", "strip_height": 12,
    "items": [{"id": 0, "demand": 4, "shape": {"type": "simple_polygon", "data": [[2, 3], [8, 3], [8, 5], [5, 5], [5, 9], [2, 9]]}}]})");
  document["items"][0]["orientation"] = Json::parse(orientation);
  return document;
}

const Shape& shape_of(const Result<MarkerFile>& file) {
  if (!file) throw std::runtime_error{file.error().field + ": " + file.error().message};
  return file->marker.shapes[0];
}

TEST(Orientations, AreReadInAllModes) {
  const auto listed = read_document(instance(R"({"rotation": {"mode": "discrete", "angles": [90, 0]}})"));
  EXPECT_EQ(shape_of(listed).rotations, (std::vector<Angle>{{90}, {0}}));
  EXPECT_EQ(listed->marker.unplaced.size(), 4u);
  const auto steps = read_document(instance(R"({"rotation": {"mode": "stepped", "step": 120}})"));
  EXPECT_EQ(shape_of(steps).rotations, (std::vector<Angle>{{0}, {120}, {240}}));
  const auto any = read_document(instance(R"({"rotation": {"mode": "continuous"}})"));
  EXPECT_TRUE(shape_of(any).rotations.empty());
}

TEST(Orientations, ReflectionsAreNotReadWhichIsNoted) {
  const auto file =
      read_document(instance(R"({"rotation": {"mode": "stepped", "step": 180}, "reflection_axes": [90]})"));
  EXPECT_FALSE(shape_of(file).may_flip);
  ASSERT_EQ(file->notes.size(), 1u);
  EXPECT_EQ(file->notes[0].field, "/items/0/orientation");
}

TEST(Orientations, AreWrittenInTheFormInWhichTheyWereRead) {
  for (const char* const form : {R"({"rotation": {"mode": "discrete", "angles": [90, 0]}})",
                                 R"({"rotation": {"mode": "continuous"}, "reflection_axes": [0]})"}) {
    const auto file = read_document(instance(form));
    ASSERT_TRUE(file);
    const auto written = marker_document(*file, Format::kSparrow);
    ASSERT_TRUE(written);
    EXPECT_EQ((*written)["items"][0]["orientation"], Json::parse(form));
    EXPECT_FALSE((*written)["items"][0].contains("allowed_orientations"));
    EXPECT_EQ(read_document(*written)->marker, file->marker);
  }
}

TEST(Orientations, OtherFieldsOfThatNameAreNotWritten) {
  for (const char* const other : {"7", R"("face up")"}) {
    const auto read = read_document(instance(R"({"rotation": {"mode": "continuous"}})"));
    ASSERT_TRUE(read);
    MarkerFile file = *read;
    file.attributes.shapes[0]["orientation"] = Json::parse(other);
    const auto written = marker_document(file, Format::kSparrow);
    ASSERT_TRUE(written);
    EXPECT_FALSE((*written)["items"][0].contains("orientation"));
    EXPECT_TRUE(read_document(*written));
  }
}

TEST(Orientations, MistakesAreNamedWithTheirField) {
  for (const auto& [form, field] : std::vector<std::pair<const char*, const char*>>{
           {"7", "/items/0/orientation"},
           {"{}", "/items/0/orientation/rotation"},
           {R"({"rotation": {"angles": [0]}})", "/items/0/orientation/rotation/mode"},
           {R"({"rotation": {"mode": "some", "angles": [0]}})", "/items/0/orientation/rotation/mode"},
           {R"({"rotation": {"mode": "discrete", "angles": []}})", "/items/0/orientation/rotation/angles"},
           {R"({"rotation": {"mode": "discrete", "angles": [0, 400]}})", "/items/0/orientation/rotation/angles/1"},
           {R"({"rotation": {"mode": "stepped", "step": 100}})", "/items/0/orientation/rotation/step"},
           {R"({"rotation": {"mode": "stepped", "step": 0.01}})", "/items/0/orientation/rotation/step"}}) {
    const auto file = read_document(instance(form));
    ASSERT_FALSE(file) << form;
    EXPECT_EQ(file.error().field, field);
  }
  Json both = instance(R"({"rotation": {"mode": "continuous"}})");
  both["items"][0]["allowed_orientations"] = Json::parse("[0]");
  EXPECT_EQ(read_document(both).error().field, "/items/0/orientation");
}

}  // namespace
}  // namespace selvage::protocol::formats
