// The example markers are read, written in every format and read again without any change.
#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "protocol/json/fields.h"
#include "tests/protocol/formats/samples.h"
#include "tests/support/repository.h"

namespace selvage::protocol::formats {
namespace {

struct Example {
  const char* name;
  std::size_t pieces, shapes;
  double length;
};
void PrintTo(const Example& example, std::ostream* out) {
  *out << example.name;
}

class ExampleMarker : public testing::TestWithParam<Example> {
 protected:
  std::string text_ = test::garment_text(GetParam().name);
};

TEST_P(ExampleMarker, IsReadAsItIs) {
  const auto file = read_marker(text_);
  ASSERT_TRUE(file) << json::describe(file.error());
  EXPECT_EQ(file->marker.name, GetParam().name);
  EXPECT_EQ(file->marker.pieces.size(), GetParam().pieces);
  EXPECT_EQ(file->marker.shapes.size(), GetParam().shapes);
  EXPECT_EQ(to_decimal(length_of(file->marker), file->marker.resolution), GetParam().length);
  EXPECT_EQ(file->marker.shapes[0].tilt_limit, Angle::of_degrees(3));
  EXPECT_TRUE(file->notes.empty());
  EXPECT_TRUE(is_valid(file->marker));
}

TEST_P(ExampleMarker, SurvivesEveryFormUnchanged) {
  const auto file = read_marker(text_);
  ASSERT_TRUE(file);
  for (const Format format : {Format::kNative, Format::kSparrow}) {
    const auto written = write_marker(*file, format);
    ASSERT_TRUE(written);
    const auto back = read_marker(*written);
    ASSERT_TRUE(back) << json::describe(back.error());
    EXPECT_EQ(back->marker, file->marker);
    EXPECT_EQ(back->attributes.shapes.size(), file->attributes.shapes.size());
    EXPECT_EQ(*write_marker(*back, Format::kSparrow), *write_marker(*file, Format::kSparrow));
  }
}

INSTANTIATE_TEST_SUITE_P(All, ExampleMarker,
                         testing::Values(Example{"jeans_02g", 40, 28, 2460.35}, Example{"charlie_04g", 72, 48, 5084},
                                         Example{"simon_06g", 114, 56, 8627.92}, Example{"jeans_06g", 120, 56, 7238},
                                         Example{"jeans_22g", 440, 70, 26663}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace selvage::protocol::formats
