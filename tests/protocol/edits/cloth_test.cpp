// Cloth's rules given for a whole marker at once.
#include "protocol/edits/cloth.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/marker/validity.h"
#include "protocol/document/annotations.h"
#include "tests/protocol/formats/samples.h"

namespace selvage {
namespace {

using protocol::edits::Cloth;
using protocol::edits::ClothNap;
using protocol::edits::with_cloth;

// Two bundles of two pieces, one of them unplaced.
MarkerFile two_bundles() {
  return test::read(test::json(R"({
    "format": "selvage-marker", "version": 1, "name": "", "strip": {"width": 100, "margin": 1}, "resolution": 0.01,
    "shapes": [{"id": "s", "outline": [[0, 0], [40, 0], [40, 20], [0, 10]], "rotations": [0, 180]}],
    "pieces": [{"id": "M-A 1", "shape": "s", "at": [1, 1], "attributes": {"bundle": "M-A"}},
               {"id": "M-A 2", "shape": "s", "at": [41, 1], "attributes": {"bundle": "M-A"}},
               {"id": "M-B 1", "shape": "s", "at": [1, 30], "attributes": {"bundle": "M-B"}}],
    "unplaced": [{"id": "M-B 2", "shape": "s", "attributes": {"bundle": "M-B"}}]})"));
}

MarkerFile with(const Cloth& cloth, MarkerFile file = two_bundles()) {
  auto given = with_cloth(std::move(file), cloth);
  if (!given) throw std::runtime_error(given.error().field + ": " + given.error().message);
  return *std::move(given);
}
std::string refused(const Cloth& cloth, MarkerFile file = two_bundles()) {
  const auto given = with_cloth(std::move(file), cloth);
  return given ? "" : given.error().field;
}

TEST(Cloth, WithoutRulesChangesNothing) {
  EXPECT_EQ(with({}).marker, two_bundles().marker);
}

TEST(Cloth, StripHasMarginsAndRepeats) {
  const Strip strip =
      with({.margin = 2, .margin_below = 3.5, .margin_above = 4, .repeat_along = 6.4, .repeat_phase = {{1, -2}}})
          .marker.strip;
  EXPECT_EQ(strip.margin, 200);
  EXPECT_EQ(strip.below, 350);
  EXPECT_EQ(strip.above, 400);
  EXPECT_EQ(strip.repeat, (marker::Repeat{.along = 640, .across = 0, .phase = {100, -200}}));
}

TEST(Cloth, AnAxisOfTheRepeatThatIsNotGivenIsUnchanged) {
  MarkerFile file = two_bundles();
  file.marker.strip.repeat = {.along = 500, .across = 700, .phase = {10, 10}};
  EXPECT_EQ(with({.repeat_along = 6}, file).marker.strip.repeat, (marker::Repeat{600, 700, {10, 10}}));
}

TEST(Cloth, BundlesBecomeShades) {
  const Marker marker = with({.shade = 90}).marker;
  EXPECT_EQ(marker.shade, 9000);
  EXPECT_EQ(marker.pieces[1].rules.shade, "M-A");
  EXPECT_EQ(marker.unplaced[0].rules.shade, "M-B");
  MarkerFile bare = two_bundles();
  bare.attributes.pieces.assign(3, Json::object());
  bare.attributes.unplaced.assign(1, Json::object());
  const MarkerFile without = with({.shade = 90}, bare);
  ASSERT_EQ(without.notes.size(), 1U);
  EXPECT_EQ(without.notes[0].field, "/shade");
}

// A piece that is rotated keeps its box.
TEST(Cloth, EverySecondBundleLiesDown) {
  const MarkerFile file = with({.nap_direction = ClothNap::kUpAndDown});
  const Marker& marker = file.marker;
  EXPECT_EQ(marker.pieces[0].rules.nap, marker::Nap::kUp);
  EXPECT_EQ(marker.pieces[1].rules.nap, marker::Nap::kUp);
  EXPECT_EQ(marker.pieces[2].rules.nap, marker::Nap::kDown);
  EXPECT_EQ(marker.unplaced[0].rules.nap, marker::Nap::kDown);
  EXPECT_EQ(marker.pieces[2].orientation.rotation.degrees, 180);
  EXPECT_EQ(box_of(placed_outline(marker, PieceId{2})), box_of(placed_outline(two_bundles().marker, PieceId{2})));
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_TRUE(is_valid(marker));
}

TEST(Cloth, ImpossibleNapIsRefused) {
  MarkerFile one_way = two_bundles();
  one_way.marker.shapes[0].rotations = {Angle{}};
  EXPECT_EQ(refused({.nap_direction = ClothNap::kDown}, one_way), "/pieces/0/rules/nap");
  MarkerFile locked = two_bundles();
  locked.marker.pieces[2].locked = true;
  EXPECT_EQ(refused({.nap_direction = ClothNap::kUpAndDown}, locked), "/pieces/2/rules/nap");
  MarkerFile bare = two_bundles();
  bare.attributes.pieces.assign(3, Json::object());
  bare.attributes.unplaced.assign(1, Json::object());
  EXPECT_EQ(refused({.nap_direction = ClothNap::kUpAndDown}, bare), "/napDirection");
}

TEST(Cloth, NapTurnsNoPieceWithALockOrAGroup) {
  for (const Locks locks : {Locks{true, false, false}, Locks{false, true, false}, Locks{false, false, true}}) {
    MarkerFile locked = two_bundles();
    locked.marker.pieces[2].locked = locks;
    EXPECT_EQ(refused({.nap_direction = ClothNap::kUpAndDown}, locked), "/pieces/2/rules/nap");
  }
  MarkerFile grouped = two_bundles();
  grouped.marker.pieces[1].group = grouped.marker.pieces[2].group = "g";
  EXPECT_EQ(refused({.nap_direction = ClothNap::kUpAndDown}, grouped), "/pieces/2/rules/nap");
  EXPECT_EQ(refused({.nap_direction = ClothNap::kUp}, grouped), "");
}

Cloth with_zones(std::vector<protocol::edits::ClothZone> zones) {
  Cloth cloth;
  cloth.zones = std::move(zones);
  return cloth;
}

TEST(Cloth, ZonesLieAtTheGivenPositions) {
  MarkerFile file = two_bundles();
  file.marker.pieces[0].id = "zone 1";
  const MarkerFile given = with(with_zones({{{60, 40}, {70, 100}, {}}, {{-5, 0}, {0, 100}, 2}}), file);
  ASSERT_EQ(given.marker.pieces.size(), 5U);
  const Piece& zone = given.marker.pieces[3];
  EXPECT_EQ(zone.id, "zone 2");  // another piece has the first name
  EXPECT_TRUE(zone.rules.zone && zone.locked && !zone.rules.quality);
  EXPECT_EQ(given.marker.pieces[4].rules.quality, 2);
  EXPECT_EQ(box_of(placed_outline(given.marker, PieceId{3})), (Box{{6000, 4000}, {7000, 10000}}));
  EXPECT_EQ(given.attributes.pieces.size(), 5U);
  EXPECT_EQ(given.attributes.shapes.size(), 3U);
  EXPECT_EQ(refused(with_zones({{{60, 40}, {60, 100}, {}}})), "/zones/0/to");
  EXPECT_EQ(refused(with_zones({{{1e300, 40}, {60, 100}, {}}})), "/zones/0/from");
}

TEST(Cloth, ManyZonesAndBundlesTakeNoLonger) {
  MarkerFile file = two_bundles();
  const Piece piece = file.marker.pieces[0];
  for (std::size_t k = 0; k < 9'000; ++k) {
    file.marker.pieces.push_back(piece);
    file.marker.pieces.back().id = "zone " + std::to_string(2 * k + 1);
    file.attributes.pieces.push_back({{"bundle", std::to_string(k)}});
  }
  Cloth cloth = with_zones(std::vector<protocol::edits::ClothZone>(10'000, {{60, 40}, {70, 100}, {}}));
  cloth.nap_direction = ClothNap::kUpAndDown;
  const MarkerFile given = with(cloth, file);
  EXPECT_EQ(given.marker.pieces[9'003].id, "zone 2");  // half of the first 18,000 names are taken
  EXPECT_EQ(given.marker.pieces[9'004].id, "zone 4");
  EXPECT_EQ(given.marker.pieces[19'002].id, "zone 19000");
  EXPECT_EQ(given.marker.pieces[3 + 7].rules.nap, marker::Nap::kDown);
  EXPECT_EQ(given.marker.pieces[3 + 8].rules.nap, marker::Nap::kUp);
}

TEST(Cloth, RulesAreThoseOfAPieceOrOfAShape) {
  Cloth cloth;
  cloth.piece_rules.emplace(2);
  (*cloth.piece_rules)[0].shape = "s";
  (*cloth.piece_rules)[0].rules.to = 90;
  (*cloth.piece_rules)[1].piece = "M-A 2";
  (*cloth.piece_rules)[1].rules.below = 0;
  const Marker marker = with(cloth).marker;
  EXPECT_EQ(marker.pieces[0].rules, (marker::Rules{.to = 9000}));
  EXPECT_EQ(marker.pieces[1].rules, (marker::Rules{.below = 0}));
  EXPECT_EQ(marker.unplaced[0].rules, (marker::Rules{.to = 9000}));
  (*cloth.piece_rules)[1].piece = "none";
  EXPECT_EQ(refused(cloth), "/pieceRules/1/piece");
  (*cloth.piece_rules)[0].shape = "none";
  EXPECT_EQ(refused(cloth), "/pieceRules/0/shape");
}

TEST(Cloth, TheLastRulesOfAPieceCountAndManyTakeNoLonger) {
  MarkerFile file = two_bundles();
  const Piece piece = file.marker.pieces[0];
  for (std::size_t k = 0; k < 9'000; ++k) {
    file.marker.pieces.push_back(piece);
    file.marker.pieces.back().id = std::to_string(k);
    file.attributes.pieces.push_back(Json::object());
  }
  Cloth cloth;
  cloth.piece_rules.emplace(protocol::edits::kMaxEdits);
  for (std::size_t k = 0; k < protocol::edits::kMaxEdits; ++k) {
    protocol::edits::RulesOfPieces& rules = (*cloth.piece_rules)[k];
    if (k % 2 == 0) rules.shape = "s";
    if (k % 2 == 1) rules.piece = std::to_string(k % 9'000);
    rules.rules.quality = static_cast<int>(k % 100);
  }
  cloth.piece_rules->back().piece = "M-A 1";
  const Marker marker = with(cloth, file).marker;
  EXPECT_EQ(marker.pieces[0].rules, (marker::Rules{.quality = 99}));
  EXPECT_EQ(marker.pieces[1].rules, (marker::Rules{.quality = 98}));
  EXPECT_EQ(marker.unplaced[0].rules, (marker::Rules{.quality = 98}));
}

TEST(Cloth, BlocksAreWidenedOnTheirSides) {
  MarkerFile file = two_bundles();
  file.marker.pieces.resize(1);
  file.attributes.pieces.resize(1);
  Cloth cloth;
  cloth.blocks.emplace(1);
  (*cloth.blocks)[0].shape = "s";
  (*cloth.blocks)[0].right = 5;
  (*cloth.blocks)[0].above = 2.5;
  const MarkerFile given = with(cloth, file);
  EXPECT_EQ(given.marker.shapes[0].outline, (Polygon{{0, 0}, {4500, 0}, {4500, 2250}, {4000, 2250}, {0, 1250}}));
  const auto drawn = protocol::document::annotations_of(given.attributes.shapes[0]);
  ASSERT_EQ(drawn.lines.size(), 1U);
  EXPECT_EQ(given.notes.size(), 1U);  // they may overlap now
  EXPECT_TRUE(drawn.lines[0].closed);
  EXPECT_EQ(drawn.lines[0].points[2], (protocol::document::Spot{40, 20}));
  (*cloth.blocks)[0].above = 90;
  EXPECT_EQ(refused(cloth, file), "/pieces/0");  // wider than the strip
  (*cloth.blocks)[0].shape = "none";
  EXPECT_EQ(refused(cloth, file), "/blocks/0/shape");
}

TEST(Cloth, AShapeHasOneBlock) {
  MarkerFile file = two_bundles();
  file.marker.pieces.resize(1);
  file.attributes.pieces.resize(1);
  Cloth cloth;
  cloth.blocks.emplace(2);
  (*cloth.blocks)[0].right = 5;
  (*cloth.blocks)[1].shape = "s";
  const auto twice = with_cloth(file, cloth);
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().code, ErrorCode::kOutOfRange);
  EXPECT_EQ(twice.error().field, "/blocks/1/shape");
  EXPECT_EQ(twice.error().message, "\"s\" has a block already; one for each shape is allowed");
  (*cloth.blocks)[1].shape.reset();
  EXPECT_EQ(refused(cloth, file), "/blocks/1");
}

// A frame with a hole, and one that is filled because its hole touches the outline.
MarkerFile frames() {
  return test::read(test::json(R"({
    "format": "selvage-marker", "version": 1, "name": "", "strip": {"width": 100},
    "shapes": [{"id": "frame", "outline": [[0, 0], [100, 0], [100, 100], [0, 100]],
                "holes": [[[20, 20], [80, 20], [80, 80], [20, 80]]]},
               {"id": "touched", "outline": [[0, 0], [100, 0], [100, 100], [0, 100]],
                "holes": [[[0, 20], [80, 20], [80, 80]]]},
               {"id": "square", "outline": [[0, 0], [50, 0], [50, 50], [0, 50]]}],
    "pieces": [{"id": "f", "shape": "frame", "at": [0, 0]}, {"id": "s", "shape": "square", "at": [25, 25]},
               {"id": "t", "shape": "touched", "at": [100, 0]}]})"));
}

TEST(Cloth, HolesAreFilledUnlessTheyAreOpen) {
  EXPECT_EQ(frames().marker.shapes[0].outline.size(), 4U);
  EXPECT_FALSE(is_valid(frames().marker));
  EXPECT_EQ(with({.open_holes = false}, frames()).marker, frames().marker);
  const MarkerFile open = with({.open_holes = true}, frames());
  EXPECT_TRUE(is_valid(open.marker));
  EXPECT_EQ(open.marker.shapes[0].outline.size(), 10U);
  EXPECT_EQ(open.marker.shapes[1].outline.size(), 4U);
  // Only the hole that stays filled is still noted as filled.
  ASSERT_EQ(frames().notes.size(), 2U);
  ASSERT_EQ(open.notes.size(), 2U);
  EXPECT_EQ(open.notes[0], frames().notes[1]);
  EXPECT_EQ(open.notes[1].field, "/openHoles");
  EXPECT_EQ(with({.open_holes = true}, open).marker, open.marker);
}

TEST(Cloth, OnlyNotesOfOpenHolesAreTakenBack) {
  MarkerFile file = frames();
  file.notes = {{"/shapes/0/holes", "filled"},           {"/shapes/1/holes", "filled"},
                {"/shapes/10/holes", "filled"},          {"/items/0/shape/data/inner", "filled"},
                {"/items/1/shape/data/inner", "filled"}, {"/0/holes", "another"}};
  std::vector<std::string> fields;
  for (const Note& note : with({.open_holes = true}, file).notes) fields.push_back(note.field);
  EXPECT_EQ(fields, (std::vector<std::string>{"/shapes/1/holes", "/shapes/10/holes", "/items/1/shape/data/inner",
                                              "/0/holes", "/openHoles"}));
}

TEST(Cloth, OpenHolesAreNotedWhereThereAreNone) {
  EXPECT_EQ(with({.open_holes = true}).notes.back().text, "no shape has a hole");
}

TEST(Cloth, MarginsThatLeaveNothingAreRefused) {
  EXPECT_EQ(refused({.margin_below = 60, .margin_above = 60}), "/strip/above");
}

}  // namespace
}  // namespace selvage
