// Coordinates at the limits of the file format and of the lattice.
#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>

#include "core/marker/validity.h"
#include "protocol/formats/native.h"
#include "tests/core/motion/markers.h"
#include "tests/extremes/reached.h"
#include "tests/extremes/soundness.h"
#include "tests/support/garment.h"
#include "tests/support/json_at.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

using test::Random;
using test::reached;
using test::soundly_compacted;

Json document_of(const Marker& marker) {
  MarkerFile file;
  file.marker = marker;
  file.attributes.shapes.assign(marker.shapes.size(), Json::object());
  file.attributes.pieces.assign(marker.pieces.size(), Json::object());
  return protocol::formats::native_document(file);
}

// The value times 10^exponent as a decimal: its digits are unchanged.
double shifted(double value, int exponent) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific).ptr;
  const std::string written{text.data(), end};
  const std::size_t e = written.find('e');
  return std::stod(written.substr(0, e + 1) + std::to_string(std::stoi(written.substr(e + 1)) + exponent));
}
template <class Change>
void change_numbers(Json& value, const Change& change) {
  if (value.is_number()) value = change(value.get<double>());
  for (Json& inner : value) change_numbers(inner, change);
  for (const auto& [key, field] : value.items()) change_numbers(value[key], change);
}
// Applies a change to every length of the document, and lets the reader choose the resolution.
template <class Change>
Json with_lengths(Json document, const Change& change) {
  document.erase("resolution");
  change_numbers(document["strip"], change);
  change_numbers(document["spacing"], change);
  for (Json& shape : document["shapes"]) change_numbers(shape["outline"], change);
  for (Json& piece : document["pieces"]) change_numbers(piece["at"], change);
  return document;
}

// Visits every coordinate of a piece's position and of a shape's outline.
template <class Visit>
void for_each_length(Json document, const Visit& visit) {
  const auto look_at = [&](double x) {
    visit(x);
    return x;
  };
  for (Json& shape : document["shapes"]) change_numbers(shape["outline"], look_at);
  for (Json& piece : document["pieces"]) change_numbers(piece["at"], look_at);
}

std::vector<Vec> positions(const Marker& marker) {
  std::vector<Vec> at;
  for (const Piece& piece : marker.pieces) at.push_back(piece.at);
  return at;
}

Json in_units_of(int exponent, const Json& document) {
  return with_lengths(document, [&](double x) { return shifted(x, exponent); });
}

// Every unit gives the same lattice and therefore exactly the same result.
void expect_the_same_in_units(const Marker& marker, std::span<const int> exponents, double compacts_to) {
  const Json document = document_of(marker);
  const double width = to_decimal(marker.strip.width, marker.resolution);
  std::optional<motion::compaction::Compaction> first;
  for (const int exponent : exponents) {
    SCOPED_TRACE(exponent);
    const auto read = protocol::formats::read_document(in_units_of(exponent, document));
    ASSERT_TRUE(read) << read.error().field << read.error().message;
    EXPECT_EQ(shifted(to_decimal(read->marker.strip.width, read->marker.resolution), -exponent), width);
    const motion::compaction::Compaction result = soundly_compacted(read->marker);
    if (!first) first = result;
    EXPECT_EQ(positions(result.marker), positions(first->marker));
    EXPECT_EQ(result.length_after, first->length_after);
    EXPECT_LT(result.length_after, result.length_before);
  }
  const double ratio = static_cast<double>(first->length_after) / static_cast<double>(first->length_before);
  reached("after / before", ratio);
  EXPECT_LE(ratio, compacts_to);
}

// Strip widths from 1.5e-6 to 1.5e8.
TEST(ExtremeCoordinates, TheSameMarkerInUnitsOf1em9To1e5) {
  expect_the_same_in_units(test::garment("jeans_02g"), std::array{0, -9, -6, -3, 3, 5}, 0.9967);
}

// A strip 1,000 wide with a piece of size 1.  In the smallest and the largest of these units, its width is the least
// and the greatest that a file may contain.
TEST(ExtremeCoordinates, FromTheNarrowestStripToTheWidest) {
  Marker marker = test::loose_marker(7, 6, 4, 115'000);
  ASSERT_EQ(to_decimal(marker.strip.width, marker.resolution), 1000);
  marker.shapes.push_back(test::shape("speck", test::rectangle(1000, 1000)));
  marker.pieces.push_back(marker.pieces.front());
  marker.pieces.back().id = "speck";
  marker.pieces.back().shape = ShapeId{static_cast<std::uint32_t>(marker.shapes.size() - 1)};
  marker.pieces.back().at = {0, marker.strip.width - 1000};
  marker.pieces.back().orientation = {};
  expect_the_same_in_units(marker, std::array{0, -9, 6}, 0.6563);
  const Json document = document_of(marker);
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const int exponent : {-9, 6}) {
    for_each_length(in_units_of(exponent, document), [&](double x) {
      if (x != 0) least = std::min(least, std::abs(x));
      most = std::max(most, std::abs(x));
    });
  }
  reached("least coordinate", least);
  reached("largest coordinate", most);
  EXPECT_LE(least, 1e-9);
  EXPECT_GE(most, 1e9);
  for (const int exponent : {-10, 7}) {  // a tenth of the least width, ten times the greatest
    const auto refused = protocol::formats::read_document(in_units_of(exponent, document));
    ASSERT_FALSE(refused) << exponent;
    EXPECT_EQ(refused.error().code, ErrorCode::kOutOfRange);
    EXPECT_EQ(refused.error().field, "/strip/width");
    EXPECT_NE(refused.error().message.find(exponent < 0 ? "1e-07" : "10000000000"), std::string::npos)
        << refused.error().message;
  }
}

// In inches, lengths are not exact decimals: rounding differs, but the compaction takes the same path.
TEST(ExtremeCoordinates, UnitsWithoutCommonMeasureGiveTheSameLength) {
  const Json document = document_of(test::garment("jeans_02g"));
  const auto ratio = [&](double factor) {
    const auto read = protocol::formats::read_document(with_lengths(document, [&](double x) { return x * factor; }));
    if (!read) {
      ADD_FAILURE() << read.error().message;
      return 0.0;
    }
    const motion::compaction::Compaction result = soundly_compacted(read->marker);
    return static_cast<double>(result.length_after) / static_cast<double>(result.length_before);
  };
  const double plain = ratio(1);
  double farthest = 0;
  for (const double factor : {1 / 25.4, 1.0 / 3, 3.14159265358979, 1e5 / 7}) {
    farthest = std::max(farthest, std::abs(ratio(factor) - plain));
  }
  reached("ratios apart", farthest);
  EXPECT_LT(farthest, 1e-6);
}

// Two rows of squares with gaps between them.
Marker squares(Resolution resolution, Coord side, std::size_t columns) {
  test::Layout layout{2 * side};
  const auto square = layout.shape_of(test::rectangle(side, side));
  for (std::size_t k = 0; k < columns; ++k) {
    const auto x = static_cast<Coord>(k) * (side + std::max<Coord>(1, side / 100));
    layout.put(square, {x, 0}).put(square, {x, side});
  }
  Marker marker = layout.marker();
  marker.resolution = resolution;
  return marker;
}

TEST(ExtremeCoordinates, TheCoarsestAndTheFinestLattice) {
  for (const int exponent : {geometry::kFinestExponent, geometry::kCoarsestExponent}) {
    // A strip as wide as the lattice limit allows, and one two units wide with squares of a single unit.
    for (const Coord side : {kLatticeLimit / 4 - 1, Coord{1}}) {
      const Marker marker = squares({exponent}, side, 3);
      const motion::compaction::Compaction result = soundly_compacted(marker);
      EXPECT_EQ(result.length_after, 3 * side) << exponent << ' ' << side;
      for (const Piece& piece : result.marker.pieces) {
        EXPECT_EQ(to_lattice(to_decimal(piece.at.x, marker.resolution), marker.resolution), piece.at.x);
      }
    }
  }
  reached("widest strip, lattice units", static_cast<double>(kLatticeLimit / 2 - 2));
  reached("narrowest strip, lattice units", 2);
}

// Fifty pieces of every kind in a row, each 25 times as long as wide, with gaps of a hundredth of their length.
std::vector<Polygon> row_of_pieces() {
  Random random{17};
  constexpr Coord kAcross = Coord{1} << 28;
  std::vector<Polygon> row;
  Coord end = 0;
  while (row.size() < 50) {
    Polygon outline = test::random_polygon(random, kAcross);
    const Box box = box_of(outline);
    if (box.height() > kAcross || box.height() < kAcross * 6 / 10) continue;  // so that no two fit side by side
    for (Vec& v : outline) v = {(v.x - box.low.x) * 25 + end, v.y - box.low.y};
    end += 25 * box.width() * 101 / 100;
    row.push_back(std::move(outline));
  }
  return row;
}

// A marker in which every outline is a shape of its own, placed where it is drawn.
Marker as_drawn(const std::vector<Polygon>& outlines, Coord width) {
  test::Layout layout{width};
  for (const Polygon& outline : outlines) layout.put(layout.shape_of(outline), {0, 0});
  return layout.marker();
}

TEST(ExtremeCoordinates, AThousandTimesLongerThanWide) {
  const Marker marker = as_drawn(row_of_pieces(), Coord{1} << 28);
  const double aspect = static_cast<double>(length_of(marker)) / static_cast<double>(marker.strip.width);
  reached("length over width", aspect);
  ASSERT_GE(aspect, 1000);
  const motion::compaction::Compaction result = soundly_compacted(marker);
  reached("length over width, compacted",
          static_cast<double>(result.length_after) / static_cast<double>(marker.strip.width));
  EXPECT_GE(result.length_after, 1000 * marker.strip.width);
  reached("after / before", static_cast<double>(result.length_after) / static_cast<double>(result.length_before));
  EXPECT_LE(result.length_after, result.length_before / 1000 * 939);
}

TEST(ExtremeCoordinates, AThousandTimesWiderThanLong) {
  std::vector<Polygon> column;
  for (const Polygon& outline : row_of_pieces()) column.push_back(transformed(outline, Symmetry{false, 1}));
  const Coord end = box_of(column.back()).high.y;
  for (Polygon& outline : column) outline = geometry::moved(outline, {(Coord{1} << 29) - box_of(outline).low.x, 0});
  const Marker marker = as_drawn(column, end);
  const motion::compaction::Compaction result = soundly_compacted(marker);
  const double aspect = static_cast<double>(marker.strip.width) / static_cast<double>(result.length_after);
  reached("width over length", aspect);
  EXPECT_GE(aspect, 1000);
  EXPECT_LE(result.length_after, Coord{1} << 28);  // every piece has reached the left end of the strip
}

// Values that a file may not contain are rejected with the field, the value and the range allowed.
TEST(ExtremeCoordinates, BeyondTheEdgesIsRefusedByName) {
  const Json document = document_of(squares({-3}, 1'000'000, 3));
  const auto refused = [&](const char* pointer, double value, ErrorCode code, const char* field, const char* allowed) {
    SCOPED_TRACE(testing::Message() << pointer << ' ' << value);
    Json changed = document;
    test::json_at(changed, pointer) = value;
    const auto read = protocol::formats::read_document(changed);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, code);
    EXPECT_EQ(read.error().field, field);
    EXPECT_NE(read.error().message.find(allowed), std::string::npos) << read.error().message;
  };
  using enum ErrorCode;
  refused("/strip/width", 0.9e-6, kOutOfRange, "/strip/width", "0.000001");
  refused("/strip/width", 1.1e9, kOutOfRange, "/strip/width", "1000000000");
  refused("/pieces/0/at/0", 2.1e8, kBeyondLattice, "/pieces/0/at",
          "200000000");  // the limit is 100,000 times the width of 2,000
  refused("/pieces/0/at/1", -1e300, kBeyondLattice, "/pieces/0/at", "200000000");
  refused("/shapes/0/outline/2/0", 1e12, kBeyondLattice, "/pieces/4/at", "200000000");
  refused("/resolution", 1e-23, kOutOfRange, "/resolution", "1e-22");
  refused("/resolution", 1e7, kOutOfRange, "/resolution", "1e6");
  refused("/resolution", 1e-9, kBeyondLattice, "/pieces/4/at", "1099.511627776");
  refused("/spacing", 2001, kOutOfRange, "/spacing", "0 to 2000");
  reached("refusals with field, value and range", 9);
}

}  // namespace
}  // namespace selvage::test
