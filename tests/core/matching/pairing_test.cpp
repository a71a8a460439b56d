#include "core/matching/pairing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <set>
#include <string>
#include <utility>

#include "tests/support/garment.h"
#include "tests/support/random.h"

namespace selvage::matching {
namespace {

std::vector<Slot> slots_of(const Marker& marker) {
  std::vector<Slot> slots;
  for (const Piece& piece : marker.pieces) {
    const Shape& shape = marker.shapes[piece.shape.value];
    slots.push_back(slot_of(shape, piece.orientation, piece.at));
  }
  return slots;
}

TEST(Pairing, OfAMarkersOwnPiecesHasNoDifference) {
  for (const char* name : {"jeans_02g", "simon_06g"}) {
    const Marker marker = test::garment(name);
    const std::vector<Slot> slots = slots_of(marker);
    const Pairing pairing = pair_pieces({marker, {}}, slots, {});
    EXPECT_EQ(pairing.difference, 0);
    std::set<std::size_t> taken;
    for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
      ASSERT_TRUE(pairing.pairs[k]);
      taken.insert(pairing.pairs[k]->slot);
      Polygon lies = oriented(marker.shapes[marker.pieces[k].shape.value].outline, pairing.pairs[k]->orientation);
      EXPECT_EQ(box_of(lies).width(), box_of(slots[pairing.pairs[k]->slot].outline).width());
    }
    EXPECT_EQ(taken.size(), marker.pieces.size());
  }
}

TEST(Pairing, IsEmptyWhenCancelled) {
  const Marker marker = test::garment("jeans_02g");
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(pair_pieces({marker, {}}, slots_of(marker), {}, stop.get_token()).pairs.empty());
}

TEST(Pairing, LeavesOutPiecesThatMatchNoSlot) {
  Marker order = test::garment("jeans_02g");
  std::vector<Slot> slots = slots_of(order);
  Shape long_bar;
  long_bar.id = "bar";
  const Coord width = order.strip.width;
  long_bar.outline = {{0, 0}, {5 * width, 0}, {5 * width, width / 20}, {0, width / 20}};
  order.shapes.push_back(long_bar);
  Piece bar;
  bar.id = "bar";
  bar.shape = ShapeId{static_cast<std::uint32_t>(order.shapes.size() - 1)};
  order.unplaced.push_back(bar);
  const Pairing more = pair_pieces({order, {}}, slots, {});
  EXPECT_FALSE(more.pairs.back());
  EXPECT_DOUBLE_EQ(more.difference, 5.0 * static_cast<double>(width) * static_cast<double>(width / 20));

  order.unplaced.clear();
  order.pieces.pop_back();
  const Pairing fewer = pair_pieces({order, {}}, slots, {});
  for (const auto& pair : fewer.pairs) EXPECT_TRUE(pair);
  EXPECT_GT(fewer.difference, 0);
}

// Every piece is called by its shape's id.
LabelledMarker named(const Marker& marker) {
  LabelledMarker named{marker, {}};
  for (const Piece& piece : marker.pieces) named.labels.push_back({marker.shapes[piece.shape.value].id, {}});
  return named;
}

std::vector<Slot> slots_of(const LabelledMarker& labelled) {
  std::vector<Slot> slots = slots_of(labelled.marker);
  for (std::size_t k = 0; k < slots.size(); ++k) slots[k].label = labelled.labels[k];
  return slots;
}

std::size_t slot_of_piece(const Pairing& pairing, std::size_t piece) {
  return pairing.pairs[piece].value().slot;
}

// Shapes of the same outline under different names.
LabelledMarker rectangles(std::initializer_list<Label> labels) {
  LabelledMarker marker;
  for (const Label& label : labels) {
    Shape shape;
    shape.id = "r" + std::to_string(marker.labels.size());
    shape.outline = {{0, 0}, {400, 0}, {400, 200}, {0, 200}};
    Piece piece;
    piece.shape = ShapeId{static_cast<std::uint32_t>(marker.labels.size())};
    piece.at = {500 * static_cast<Coord>(marker.labels.size()), 0};
    marker.marker.shapes.push_back(shape);
    marker.marker.pieces.push_back(piece);
    marker.labels.push_back(label);
  }
  return marker;
}

TEST(Pairing, GivesAMarkersOwnPiecesTheSlotsOfTheirNames) {
  for (const char* name : {"jeans_02g", "simon_06g"}) {
    const LabelledMarker marker = named(test::garment(name));
    LabelledMarker order = marker;
    std::ranges::reverse(order.marker.pieces);
    std::ranges::reverse(order.labels);
    const std::vector<Slot> slots = slots_of(marker);
    const Pairing pairing = pair_pieces(order, slots, {});
    EXPECT_EQ(pairing.difference, 0);
    for (std::size_t k = 0; k < order.labels.size(); ++k) {
      EXPECT_EQ(order.labels[k], slots[slot_of_piece(pairing, k)].label);
    }
  }
}

TEST(Pairing, OfEqualOutlinesIsDecidedByNamesAndThenBySizes) {
  const LabelledMarker order = rectangles({{"back", "36"}, {"front", "36"}, {"front", "38"}});
  const Pairing pairing =
      pair_pieces(order, slots_of(rectangles({{"front", "38"}, {"front", "36"}, {"back", "40"}})), {});
  EXPECT_EQ(slot_of_piece(pairing, 0), 2U);
  EXPECT_EQ(slot_of_piece(pairing, 1), 1U);
  EXPECT_EQ(slot_of_piece(pairing, 2), 0U);
  EXPECT_EQ(pairing.difference, 0);
}

TEST(Pairing, ComparesIdsOfShapesWhereANameIsMissing) {
  LabelledMarker order = rectangles({{"front", {}}, {"back", {}}});
  std::swap(order.marker.shapes[0].id, order.marker.shapes[1].id);
  const auto slot_of_front = [&](const LabelledMarker& stored) {
    std::vector<Slot> slots = slots_of(stored);
    for (Slot& slot : slots) slot.untilted = {{0, 0}, {400, 0}, {400, 202}, {0, 202}};
    return slot_of_piece(pair_pieces(order, slots, {}), 0);
  };
  EXPECT_EQ(slot_of_front(rectangles({{"front", {}}, {"back", {}}})), 0U);
  EXPECT_EQ(slot_of_front(rectangles({{}, {}})), 1U);
  order.labels.clear();
  EXPECT_EQ(slot_of_front(rectangles({{"front", {}}, {"back", {}}})), 1U);
}

// A panel that is called like a small piece still takes the place of a panel.
TEST(Pairing, OfShapesThatContradictTheirNamesIsDecidedByTheShapes) {
  const LabelledMarker marker = named(test::garment("jeans_02g"));
  LabelledMarker order = marker;
  const auto area = [&](const Piece& piece) {
    return geometry::area_of(marker.marker.shapes[piece.shape.value].outline);
  };
  std::ranges::stable_sort(order.marker.pieces, std::ranges::greater{}, area);
  order.labels = named(order.marker).labels;
  std::ranges::reverse(order.labels);
  const Pairing pairing = pair_pieces(order, slots_of(marker), {});
  for (std::size_t k = 0; k < order.labels.size(); ++k) {
    const double in_slot = area(marker.marker.pieces[slot_of_piece(pairing, k)]);
    EXPECT_NEAR(in_slot, area(order.marker.pieces[k]), 0.03 * in_slot);
  }
}

// Labels raise the costs of the shapes by at most what they may cost themselves.
TEST(Pairing, IsAtMostWorseByThePricesOfLabels) {
  test::Random random{21};
  const Marker marker = test::garment("jeans_02g");
  const std::vector<Slot> plain = slots_of(marker);
  const FitTable fits{marker, plain};
  const auto costs_of = [&](const Pairing& pairing) {
    double costs = 0;
    for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
      costs += fits.best(marker.pieces[k].shape, slot_of_piece(pairing, k)).cost;
    }
    return costs;
  };
  double areas = 0;
  for (std::size_t k = 0; k < plain.size(); ++k) areas += fits.slot_area(k);
  for (int trial = 0; trial < 20; ++trial) {
    const auto any = [&] { return Label{std::string(1, static_cast<char>('a' + random.below(4))), {}}; };
    LabelledMarker order{marker, {}}, stored{marker, {}};
    for (std::size_t k = 0; k < plain.size(); ++k) {
      order.labels.push_back(any());
      stored.labels.push_back(any());
    }
    const LabelPrices prices;
    const Pairing pairing = pair_pieces(order, slots_of(stored), prices);
    if (!std::ranges::all_of(pairing.pairs, [](const auto& pair) { return pair.has_value(); })) continue;
    EXPECT_LE(costs_of(pairing), prices.name * areas);  // without labels they are 0
  }
}

TEST(Pairing, UsesAllowedOrientationsOnly) {
  test::Random random{9};
  Marker order = test::garment("jeans_02g");
  std::vector<Slot> slots = slots_of(order);
  for (Slot& slot : slots) {
    const Symmetry turn{false, random.chance(50) ? 2 : 0};
    for (Polygon* outline : {&slot.outline, &slot.untilted}) *outline = transformed(*outline, turn);
  }
  const Pairing pairing = pair_pieces({order, {}}, slots, {});
  for (std::size_t k = 0; k < order.pieces.size(); ++k) {
    if (!pairing.pairs[k]) continue;
    const Shape& shape = order.shapes[order.pieces[k].shape.value];
    EXPECT_NE(std::find(shape.rotations.begin(), shape.rotations.end(), pairing.pairs[k]->orientation.rotation),
              shape.rotations.end());
    EXPECT_FALSE(pairing.pairs[k]->orientation.flip && !shape.may_flip);
  }
}

TEST(Orientations, TakeTheSlotsTiltWhereItIsAllowed) {
  Shape shape;
  shape.rotations = {Angle{0}, Angle{180}};
  shape.tilt_limit = Angle{1};
  for (const double tilt : {0.5, -1.5}) {
    const std::vector<Orientation> orientations = orientations_of(shape, {{}, {}, Angle{tilt}});
    ASSERT_EQ(orientations.size(), 2U);
    for (const Orientation& one : orientations) EXPECT_EQ(one.tilt, tilt == 0.5 ? Angle{tilt} : Angle{});
  }
  shape.may_flip = true;
  EXPECT_EQ(orientations_of(shape, {}).size(), 4U);
  shape.rotations.clear();
  EXPECT_EQ(orientations_of(shape, {{}, Angle{30}, {}}).size(), 8U);
}

}  // namespace
}  // namespace selvage::matching
