// A law of every writer: a lattice coordinate is printed as its exact decimal.
#include <gtest/gtest.h>

#include <random>

#include "protocol/formats/decimal_marker.h"
#include "protocol/json/fields.h"
#include "tests/protocol/formats/samples.h"

namespace selvage::protocol::formats {
namespace {

// A decimal text as digits times a power of ten, without trailing zeros.
struct Digits {
  bool negative{};
  std::string digits;
  int exponent{};
  friend bool operator==(const Digits&, const Digits&) = default;
};

Digits trimmed(Digits d) {
  while (!d.digits.empty() && d.digits.front() == '0') d.digits.erase(0, 1);
  while (!d.digits.empty() && d.digits.back() == '0') {
    d.digits.pop_back();
    ++d.exponent;
  }
  if (d.digits.empty()) return {};
  return d;
}

Digits digits_of(const std::string& text) {
  Digits d;
  bool after_point = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '-') {
      d.negative = true;
    } else if (c == '.') {
      after_point = true;
    } else if (c == 'e') {
      d.exponent += std::stoi(text.substr(i + 1));
      break;
    } else {
      d.digits += c;
      d.exponent -= after_point;
    }
  }
  return trimmed(d);
}

TEST(ExactDecimals, EveryLatticeCoordinateIsPrintedExactly) {
  std::mt19937_64 random{20};
  for (int exponent = geometry::kFinestExponent; exponent <= geometry::kCoarsestExponent; ++exponent) {
    for (int i = 0; i < 5'000; ++i) {
      const auto magnitude = static_cast<int>(random() % 41);
      Coord coord = static_cast<Coord>(random() % (std::uint64_t{1} << magnitude));
      if (i % 2 == 1) coord = -coord;
      const std::string text = json::number_text(to_decimal(coord, Resolution{exponent}));
      const Digits expected = trimmed({coord < 0, std::to_string(coord < 0 ? -coord : coord), exponent});
      ASSERT_EQ(digits_of(text), expected) << coord << "e" << exponent << " printed as " << text;
    }
  }
}

TEST(ExactDecimals, WrittenMarkersReadBackOnTheSameLattice) {
  std::mt19937_64 random{21};
  MarkerFile file = test::read(test::native_squares());
  for (int i = 0; i < 500; ++i) {
    Marker& marker = file.marker;
    for (Piece& piece : marker.pieces) {
      piece.at = {static_cast<Coord>(random() % 1'000'000'000), static_cast<Coord>(random() % 1'000'000'000)};
    }
    for (const Format format : {Format::kNative, Format::kSparrow}) {
      const auto text = write_marker(file, format);
      ASSERT_TRUE(text);
      const auto back = read_marker(*text);
      ASSERT_TRUE(back) << json::describe(back.error());
      for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
        EXPECT_EQ(to_decimal(back->marker.pieces[k].at.x, back->marker.resolution),
                  to_decimal(marker.pieces[k].at.x, marker.resolution));
        EXPECT_TRUE(back->notes.empty());
      }
    }
  }
}

TEST(ExactDecimals, OutlinesLieWhereThePiecesDo) {
  Json document = test::native_squares();
  document["shapes"][0]["rotations"] = "any";
  document["pieces"][1]["rotation"] = 90;
  document["pieces"][1]["at"] = test::json("[90.0625, 10.000001]");
  const auto outlines = marker_document(test::read(document), Format::kOutlines);
  ASSERT_TRUE(outlines);
  EXPECT_EQ(
      json::to_text(*outlines),
      R"({"strip_height":100,"strip_length":90.0625,"pieces":[)"
      R"({"id":"left","outline":[[0,0],[40,0],[40,40],[0,40]]},)"
      R"({"id":"right","outline":[[90.0625,10.000001],[90.0625,50.000001],[50.0625,50.000001],[50.0625,10.000001]]}]})");
}

}  // namespace
}  // namespace selvage::protocol::formats
