// Tests of core/marker/marker.h: what make_marker accepts and rejects, length, utilisation and placed outlines.
#include "core/marker/marker.h"

#include <gtest/gtest.h>

#include "tests/core/marker/squares.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

// The code and the field of the error that make_marker returns.
std::pair<ErrorCode, std::string> error_of(const Marker& marker) {
  const auto made = make_marker(marker);
  if (made) return {};
  EXPECT_NE(made.error().message, "");
  return {made.error().code, made.error().field};
}
using Found = std::pair<ErrorCode, std::string>;

Marker with(void (*change)(Marker&)) {
  Marker marker = squares({{0, 0}, {10, 0}});
  change(marker);
  return marker;
}

TEST(MakeMarker, LeavesAWellFormedMarkerUnchanged) {
  const Marker marker = squares({{0, 0}, {5, 0}});  // they overlap, but the marker is well formed
  const auto made = make_marker(marker);
  ASSERT_TRUE(made);
  EXPECT_EQ(*made, marker);
}

TEST(MakeMarker, RejectsInvalidStripsAndSpacings) {
  EXPECT_EQ(error_of(with([](Marker& m) { m.strip.width = 0; })), Found(ErrorCode::kOutOfRange, "/strip/width"));
  EXPECT_EQ(error_of(with([](Marker& m) { m.strip.width = -5; })), Found(ErrorCode::kOutOfRange, "/strip/width"));
  EXPECT_EQ(error_of(with([](Marker& m) { m.spacing = -1; })), Found(ErrorCode::kOutOfRange, "/spacing"));
  EXPECT_EQ(error_of(with([](Marker& m) { m.spacing = 101; })), Found(ErrorCode::kOutOfRange, "/spacing"));
  EXPECT_EQ(error_of(with([](Marker& m) { m.spacing = 100; })), Found());
  EXPECT_EQ(error_of(with([](Marker& m) { m.overlap = -1; })), Found(ErrorCode::kOutOfRange, "/overlap"));
  EXPECT_EQ(error_of(with([](Marker& m) { m.overlap = 101; })), Found(ErrorCode::kOutOfRange, "/overlap"));
  EXPECT_EQ(error_of(with([](Marker& m) { m.pieces[0].overlap = 101; })),
            Found(ErrorCode::kOutOfRange, "/pieces/0/overlap"));
}

TEST(MakeMarker, RejectsNoPiecesAndTooManyPieces) {
  EXPECT_EQ(error_of(squares({})), Found(ErrorCode::kEmptyMarker, "/pieces"));
  EXPECT_EQ(error_of(squares(std::vector<Vec>(marker::kMaxPieces + 1))), Found(ErrorCode::kTooManyPieces, "/pieces"));
  EXPECT_EQ(error_of(squares(std::vector<Vec>(marker::kMaxPieces))), Found());
}

TEST(MakeMarker, ChecksUnplacedPieces) {
  const auto unplaced = [](Piece piece) {
    Marker marker = squares({{0, 0}});
    marker.unplaced = {std::move(piece)};
    return marker;
  };
  EXPECT_EQ(error_of(unplaced({.id = "0", .shape = {0}, .orientation = {}, .at = {}})),
            Found(ErrorCode::kDuplicateId, "/unplaced/0/id"));
  EXPECT_EQ(error_of(unplaced({.id = "a", .shape = {1}, .orientation = {}, .at = {}})),
            Found(ErrorCode::kUnknownShape, "/unplaced/0/shape"));
  EXPECT_EQ(error_of(unplaced({.id = "a", .shape = {0}, .orientation = {false, {90}, {}}, .at = {}})),
            Found(ErrorCode::kOrientationNotAllowed, "/unplaced/0/rotation"));
  EXPECT_EQ(error_of(unplaced({.id = "a", .shape = {0}, .orientation = {}, .at = {}, .buffer = -1})),
            Found(ErrorCode::kOutOfRange, "/unplaced/0/buffer"));
  Marker many = squares(std::vector<Vec>(marker::kMaxPieces));
  many.unplaced = {{.id = "one more", .shape = {0}, .orientation = {}, .at = {}}};
  EXPECT_EQ(error_of(many), Found(ErrorCode::kTooManyPieces, "/pieces"));

  const auto made = make_marker(unplaced({.id = "a", .shape = {0}, .orientation = {}, .at = {7, 7}}));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->unplaced[0].at, Vec{});
  EXPECT_EQ(length_of(*made), length_of(squares({{0, 0}})));
}

TEST(MakeMarker, RejectsDuplicateIdsAndUnknownShapes) {
  EXPECT_EQ(error_of(with([](Marker& m) { m.pieces[1].id = "0"; })), Found(ErrorCode::kDuplicateId, "/pieces/1/id"));
  EXPECT_EQ(error_of(with([](Marker& m) { m.shapes.push_back(m.shapes[0]); })),
            Found(ErrorCode::kDuplicateId, "/shapes/1/id"));
  EXPECT_EQ(error_of(with([](Marker& m) { m.pieces[1].shape.value = 1; })),
            Found(ErrorCode::kUnknownShape, "/pieces/1/shape"));
}

TEST(MakeMarker, RejectsPiecesWiderThanTheStrip) {
  EXPECT_EQ(error_of(with([](Marker& m) { m.strip.width = 9; })), Found(ErrorCode::kPieceTooWide, "/pieces/0"));
  EXPECT_EQ(error_of(with([](Marker& m) { m.strip.width = 10; })), Found());
  // Only the orientation of the piece counts.
  const auto bar = [](double rotation) {
    Marker marker = squares({{0, 0}, {0, 0}});
    marker.shapes.push_back({.id = "bar",
                             .outline = {{0, 0}, {500, 0}, {500, 10}, {0, 10}},
                             .rotations = {Angle::of_degrees(0), Angle::of_degrees(90)},
                             .tilt_limit = {}});
    marker.pieces[1].shape.value = 1;
    marker.pieces[1].orientation.rotation = Angle::of_degrees(rotation);
    return marker;
  };
  EXPECT_EQ(error_of(bar(0)), Found());
  EXPECT_EQ(error_of(bar(90)), Found(ErrorCode::kPieceTooWide, "/pieces/1"));
}

TEST(MakeMarker, RejectsOrientationsThatTheShapeDoesNotAllow) {
  const auto oriented_as = [](Orientation orientation, void (*allow)(Shape&)) {
    Marker marker = squares({{0, 0}});
    allow(marker.shapes[0]);
    marker.pieces[0].orientation = orientation;
    return error_of(marker);
  };
  const Found refused{ErrorCode::kOrientationNotAllowed, "/pieces/0/rotation"};
  const auto nothing = [](Shape&) {};
  const auto half_turns = [](Shape& s) { s.rotations.push_back(Angle::of_degrees(180)); };
  EXPECT_EQ(oriented_as({false, {180}, {}}, nothing), refused);
  EXPECT_EQ(oriented_as({false, {180}, {}}, half_turns), Found());
  EXPECT_EQ(oriented_as({false, {-180}, {}}, half_turns), Found());  // the same direction
  EXPECT_EQ(oriented_as({false, {540}, {}}, half_turns), Found());
  EXPECT_EQ(oriented_as({false, {90}, {}}, half_turns), refused);
  EXPECT_EQ(oriented_as({false, {37.5}, {}}, [](Shape& s) { s.rotations.clear(); }),
            Found());  // any rotation is allowed
  EXPECT_EQ(oriented_as({true, {}, {}}, nothing), refused);
  EXPECT_EQ(oriented_as({true, {}, {}}, [](Shape& s) { s.may_flip = true; }), Found());
  EXPECT_EQ(oriented_as({false, {}, {1}}, nothing), refused);
  const auto may_tilt = [](Shape& s) { s.tilt_limit = {2}; };
  EXPECT_EQ(oriented_as({false, {}, {2}}, may_tilt), Found());
  EXPECT_EQ(oriented_as({false, {}, {-2}}, may_tilt), Found());
  EXPECT_EQ(oriented_as({false, {}, {2.01}}, may_tilt), refused);
}

TEST(MakeMarker, RejectsShapesThatRoundingMakesTouchThemselves) {
  // A slot of one unit closes when the shape is turned by 45 degrees.
  Marker marker = squares({{0, 0}});
  marker.strip.width = 100'000;
  marker.shapes[0].rotations = {Angle::of_degrees(45)};
  marker.pieces[0].orientation.rotation = Angle::of_degrees(45);
  Polygon slotted{{0, 0}, {101, 0}, {101, 100}, {51, 100}};
  for (Coord y = 99; y > 10; --y) slotted.push_back({50 + y % 2 + 1, y});
  for (Coord y = 11; y < 100; ++y) slotted.push_back({50 + y % 2, y});
  slotted.push_back({50, 100});
  slotted.push_back({0, 100});
  auto clean = clean_polygon(slotted);
  ASSERT_TRUE(clean) << clean.error().message;
  marker.shapes[0].outline = clean->polygon;
  EXPECT_EQ(error_of(marker), Found(ErrorCode::kSelfIntersecting, "/pieces/0"));
}

TEST(Length, IsTheRightEndOfTheRightmostPiece) {
  EXPECT_EQ(length_of(squares({{0, 0}, {37, 20}, {12, 90}})), 47);
  EXPECT_EQ(length_of(squares({{-50, 0}})), 0);
}

TEST(Utilisation, IsTheCoveredFractionOfTheStrip) {
  EXPECT_DOUBLE_EQ(utilisation_of(squares({{0, 0}})), 0.1);
  EXPECT_DOUBLE_EQ(utilisation_of(squares({{0, 0}, {0, 10}, {10, 0}})), 0.15);
  Marker full = squares({});
  for (Coord k = 0; k < 100; ++k) {
    full.pieces.push_back(
        {.id = std::to_string(k), .shape = {0}, .orientation = {}, .at = {10 * (k / 10), 10 * (k % 10)}});
  }
  EXPECT_DOUBLE_EQ(utilisation_of(full), 1);
}

TEST(PlacedOutline, IsOrientedThenTranslated) {
  Marker marker = squares({{7, 9}});
  marker.shapes[0].outline = kTriangle;
  marker.shapes[0].may_flip = true;
  marker.pieces[0].orientation = {true, {90}, {}};
  EXPECT_EQ(placed_outline(marker, {0}), (Polygon{{7, 9}, {27, 9}, {7, 29}}));
}

}  // namespace
}  // namespace selvage::test
