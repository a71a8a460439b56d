// Every kind of invalid input gets an error with the field, the value and what is allowed.
#include <gtest/gtest.h>

#include "protocol/json/fields.h"
#include "tests/protocol/formats/samples.h"
#include "tests/support/json_at.h"

namespace selvage::protocol::formats {
namespace {

using test::json;

struct BadInput {
  const char* name;
  const char* field;  // JSON pointer of the value that is replaced; "" for the whole document
  const char* value;  // the new value; null: the field is removed
  ErrorCode code;
  const char* reported;  // the field the error names
};

void PrintTo(const BadInput& bad, std::ostream* out) {
  *out << bad.name;
}

Json changed(Json document, const BadInput& bad) {
  const std::string_view pointer{bad.field};
  if (bad.value) {
    test::json_at(document, pointer) = json(bad.value);
  } else {
    const std::size_t last = pointer.rfind('/');
    test::json_at(document, pointer.substr(0, last)).erase(pointer.substr(last + 1));
  }
  return document;
}

void expect_error(const Json& document, const BadInput& bad) {
  const auto file = read_marker(json::to_text(document));
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, bad.code) << json::describe(file.error());
  EXPECT_EQ(file.error().field, bad.reported) << json::describe(file.error());
  EXPECT_FALSE(file.error().message.empty());
}

class BadNative : public testing::TestWithParam<BadInput> {};
TEST_P(BadNative, IsRefused) {
  expect_error(changed(test::native_squares(), GetParam()), GetParam());
}

using enum ErrorCode;
INSTANTIATE_TEST_SUITE_P(
    All, BadNative,
    testing::Values(
        BadInput{"NotAnObject", "", "[1]", kWrongType, ""}, BadInput{"NoFormat", "", R"({"a": 1})", kUnknownFormat, ""},
        BadInput{"OtherFormat", "/format", R"("dxf")", kOutOfRange, "/format"},
        BadInput{"FormatMissing", "/format", nullptr, kMissingField, "/format"},
        BadInput{"OtherVersion", "/version", "2", kOutOfRange, "/version"},
        BadInput{"VersionMissing", "/version", nullptr, kMissingField, "/version"},
        BadInput{"UnknownField", "/colour", "1", kUnknownField, "/colour"},
        BadInput{"UnknownFieldOfAShape", "/shapes/0/demand", "1", kUnknownField, "/shapes/0/demand"},
        BadInput{"UnknownFieldOfAPiece", "/pieces/1/x", "1", kUnknownField, "/pieces/1/x"},
        BadInput{"UnknownFieldOfTheStrip", "/strip/height", "1", kUnknownField, "/strip/height"},
        BadInput{"StripMissing", "/strip", nullptr, kMissingField, "/strip"},
        BadInput{"ShapesMissing", "/shapes", nullptr, kMissingField, "/shapes"},
        BadInput{"PieceWithoutPlace", "/pieces/0/at", nullptr, kMissingField, "/pieces/0/at"},
        BadInput{"ShapesAnObject", "/shapes", "{}", kWrongType, "/shapes"},
        BadInput{"WidthAString", "/strip/width", R"("100")", kWrongType, "/strip/width"},
        BadInput{"WidthZero", "/strip/width", "0", kOutOfRange, "/strip/width"},
        BadInput{"WidthNegative", "/strip/width", "-100", kOutOfRange, "/strip/width"},
        BadInput{"WidthEnormous", "/strip/width", "1e308", kOutOfRange, "/strip/width"},
        BadInput{"SpacingNegative", "/spacing", "-0.1", kOutOfRange, "/spacing"},
        BadInput{"SpacingBeyondTheWidth", "/spacing", "101", kOutOfRange, "/spacing"},
        BadInput{"ResolutionNoPowerOfTen", "/resolution", "0.5", kOutOfRange, "/resolution"},
        BadInput{"VertexOfThree", "/shapes/0/outline/2", "[1, 2, 3]", kWrongType, "/shapes/0/outline/2"},
        BadInput{"VertexANull", "/shapes/0/outline/2/1", "null", kWrongType, "/shapes/0/outline/2/1"},
        BadInput{"CoordinateEnormous", "/shapes/0/outline/2/1", "1e308", kBeyondLattice, "/shapes/0/outline"},
        BadInput{"PlaceEnormous", "/pieces/1/at/0", "-1e308", kBeyondLattice, "/pieces/1/at"},
        BadInput{"PlaceBeyondTheLattice", "/pieces/1/at/0", "1e8", kBeyondLattice, "/pieces/1/at"},
        BadInput{"BeyondItsOwnResolution", "/resolution", "1e-11", kBeyondLattice, "/strip/width"},
        BadInput{"TwoVertices", "/shapes/0/outline", "[[0,0],[1,0]]", kTooFewVertices, "/shapes/0/outline"},
        BadInput{"NoVertex", "/shapes/0/outline", "[]", kTooFewVertices, "/shapes/0/outline"},
        BadInput{"OneVertexThrice", "/shapes/0/outline", "[[1,1],[1,1],[1,1]]", kTooFewVertices, "/shapes/0/outline"},
        BadInput{"NoArea", "/shapes/0/outline", "[[0,0],[1,0],[2,0]]", kZeroArea, "/shapes/0/outline"},
        BadInput{"BowTie", "/shapes/0/outline", "[[0,0],[9,9],[9,0],[0,9]]", kSelfIntersecting, "/shapes/0/outline"},
        BadInput{"HoleOfText", "/shapes/0/holes", R"([["a"]])", kWrongType, "/shapes/0/holes/0/0"},
        BadInput{"RotationsAWord", "/shapes/0/rotations", R"("some")", kWrongType, "/shapes/0/rotations"},
        BadInput{"RotationsEmpty", "/shapes/0/rotations", "[]", kWrongType, "/shapes/0/rotations"},
        BadInput{"TiltLimitTooLarge", "/shapes/0/tilt_limit", "90", kOutOfRange, "/shapes/0/tilt_limit"},
        BadInput{"RotationNotAllowed", "/pieces/0/rotation", "90", kOrientationNotAllowed, "/pieces/0/rotation"},
        BadInput{"LockedInNothingThereIs", "/pieces/0/locked", R"(["x", "z"])", kOutOfRange, "/pieces/0/locked/1"},
        BadInput{"BufferNegative", "/pieces/0/buffer", "-1", kOutOfRange, "/pieces/0/buffer"},
        BadInput{"MarginBeyondTheMiddle", "/strip/margin", "50", kOutOfRange, "/strip/margin"},
        BadInput{"LockedAString", "/pieces/0/locked", R"("yes")", kWrongType, "/pieces/0/locked"},
        BadInput{"AttributesANumber", "/pieces/0/attributes", "3", kWrongType, "/pieces/0/attributes"},
        BadInput{"ShapeUnknown", "/pieces/0/shape", R"("circle")", kUnknownShape, "/pieces/0/shape"},
        BadInput{"PieceTwice", "/pieces/1/id", R"("left")", kDuplicateId, "/pieces/1/id"},
        BadInput{"ShapeTwice", "/shapes/1", R"({"id": "square", "outline": [[0,0],[1,0],[0,1]]})", kDuplicateId,
                 "/shapes/1/id"},
        BadInput{"NoPiece", "/pieces", "[]", kEmptyMarker, "/pieces"},
        BadInput{"UnplacedANumber", "/unplaced", "1", kWrongType, "/unplaced"},
        BadInput{"UnplacedSomewhere", "/unplaced", R"([{"id": "x", "shape": "square", "at": [0, 0]}])", kUnknownField,
                 "/unplaced/0/at"},
        BadInput{"UnplacedOfNoShape", "/unplaced", R"([{"id": "x", "shape": "circle"}])", kUnknownShape,
                 "/unplaced/0/shape"},
        BadInput{"UnplacedAlsoPlaced", "/unplaced", R"([{"id": "left", "shape": "square"}])", kDuplicateId,
                 "/unplaced/0/id"},
        BadInput{"WiderThanTheStrip", "/strip/width", "39.5", kPieceTooWide, "/pieces/0"}),
    [](const auto& test) { return test.param.name; });

class BadSparrow : public testing::TestWithParam<BadInput> {};
TEST_P(BadSparrow, IsRefused) {
  expect_error(changed(test::sparrow_squares(), GetParam()), GetParam());
}

constexpr char kPlaced0[] = "/solution/layout/placed_items/0/transformation/translation";
INSTANTIATE_TEST_SUITE_P(
    All, BadSparrow,
    testing::Values(BadInput{"SolutionANumber", "/solution", "1", kWrongType, "/solution"},
                    BadInput{"DemandNegative", "/items/0/demand", "-1", kOutOfRange, "/items/0/demand"},
                    BadInput{"DemandTooLarge", "/items/0/demand", "20001", kOutOfRange, "/items/0/demand"},
                    BadInput{"HeightMissing", "/strip_height", nullptr, kMissingField, "/strip_height"},
                    BadInput{"TooWide", "/strip_height", "20", kPieceTooWide, "/solution/layout/placed_items/0"},
                    BadInput{"ResolutionOdd", "/resolution", "0.02", kOutOfRange, "/resolution"},
                    BadInput{"Rectangle", "/items/0/shape", R"({"type": "rectangle", "data": {}})", kOutOfRange,
                             "/items/0/shape/type"},
                    BadInput{"MultiPolygon", "/items/0/shape", R"({"type": "multi_polygon", "data": []})", kOutOfRange,
                             "/items/0/shape/type"},
                    BadInput{"PermissionBeyondATurn", "/items/0/allowed_orientations/1", "400", kOutOfRange,
                             "/items/0/allowed_orientations/1"},
                    BadInput{"TwoPermissions", "/items/0/orientation", "{}", kOutOfRange, "/items/0/orientation"},
                    BadInput{"ItemUnknown", "/solution/layout/placed_items/1/item_id", "8", kUnknownShape,
                             "/solution/layout/placed_items/1/item_id"},
                    BadInput{"RotationNotAllowed", "/solution/layout/placed_items/1/transformation/rotation", "45",
                             kOrientationNotAllowed, "/solution/layout/placed_items/1/transformation/rotation"},
                    BadInput{"PlaceEnormous", kPlaced0, "[1e300, 0]", kBeyondLattice, kPlaced0},
                    BadInput{"NoArea", "/items/0/shape/data", "[[0,0],[1,0],[2,0]]", kZeroArea, "/items/0/shape/data"},
                    BadInput{"NoAreaWithHoles", "/items/0/shape",
                             R"({"type": "polygon", "data": {"outer": [[0,0],[1,0],[2,0]]}})", kZeroArea,
                             "/items/0/shape/data/outer"}),
    [](const auto& test) { return test.param.name; });

TEST(BadInput, AHundredThousandVerticesAreRefusedWithTheLimit) {
  Json document = test::native_squares();
  Json& outline = document["shapes"][0]["outline"] = Json::array();
  for (int i = 0; i < 50'000; ++i) outline.push_back(Json::array({i * 1e-3, 0}));
  for (int i = 50'000; i > 0; --i) outline.push_back(Json::array({i * 1e-3, 10}));
  const auto file = read_document(document);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, kTooManyVertices);
  EXPECT_EQ(file.error().field, "/shapes/0/outline");
  EXPECT_NE(file.error().message.find(std::to_string(geometry::kMaxVertices)), std::string::npos)
      << file.error().message;
}

TEST(BadInput, MorePiecesThanTheLimitAreRefused) {
  Json document = test::native_squares();
  Json& pieces = document["pieces"] = Json::array();
  for (std::size_t i = 0; i <= marker::kMaxPieces; ++i) {
    pieces.push_back({{"id", i}, {"shape", "square"}, {"at", Json::array({i * 50, 0})}});
  }
  const auto file = read_document(document);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, kTooManyPieces);
}

TEST(BadInput, OnePieceIsFine) {
  Json document = test::native_squares();
  document["pieces"].erase(1);
  EXPECT_EQ(test::read(document).marker.pieces.size(), 1u);
}

}  // namespace
}  // namespace selvage::protocol::formats
