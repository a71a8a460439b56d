#include "core/matching/pairing.h"

#include "core/matching/assignment.h"

namespace selvage::matching {
namespace {

double shape_area(const Shape& shape) {
  return static_cast<double>(doubled_area(shape.outline)) / 2;
}

}  // namespace

Pairing pair_pieces(const Marker& order, std::span<const Slot> slots) {
  std::vector<const Piece*> pieces;
  for (const auto* list : {&order.pieces, &order.unplaced}) {
    for (const Piece& piece : *list) pieces.push_back(&piece);
  }
  const FitTable fits{order, slots};
  Costs costs{pieces.size(), slots.size()};
  for (std::size_t row = 0; row < pieces.size(); ++row) {
    for (std::size_t column = 0; column < slots.size(); ++column) {
      costs(row, column) = fits.best(pieces[row]->shape, column).cost;
    }
  }
  const Assignment assignment = assign(costs);
  Pairing pairing;
  std::vector<bool> taken(slots.size());
  for (std::size_t row = 0; row < pieces.size(); ++row) {
    const double area = shape_area(order.shapes[pieces[row]->shape.value]);
    auto& pair = pairing.pairs.emplace_back();
    if (const auto column = assignment.column_of[row]) {
      const Fit fit = fits.best(pieces[row]->shape, *column);
      if (fit.difference <= kUnlike * (area + fits.slot_area(*column)) / 2) {
        pair = Pair{*column, fit.orientation};
        pairing.difference += fit.difference;
        taken[*column] = true;
      }
    }
    if (!pair) pairing.difference += area;
  }
  for (std::size_t column = 0; column < slots.size(); ++column) {
    if (!taken[column]) pairing.difference += fits.slot_area(column);
  }
  return pairing;
}

}  // namespace selvage::matching
