#include "core/matching/pairing.h"

#include <map>
#include <string>
#include <utility>

#include "core/matching/assignment.h"

namespace selvage::matching {
namespace {

constexpr double kOtherId = 1.05;  // factor on the cost of shapes whose ids differ, where a name is not known

double shape_area(const Shape& shape) {
  return geometry::area_of(shape.outline);
}

// Texts as numbers, which are compared thousands of times; 0 is the empty text.
class Numbered {
 public:
  std::size_t operator()(const std::string& text) {
    return text.empty() ? 0 : numbers_.try_emplace(text, numbers_.size() + 1).first->second;
  }

 private:
  std::map<std::string, std::size_t> numbers_;
};

bool differ(std::size_t one, std::size_t other) {
  return one != 0 && other != 0 && one != other;
}

// What a piece and a slot are compared by.
struct Compared {
  std::size_t name{}, size{}, id{};
  double area{};
};

class Comparison {
 public:
  Comparison(const LabelledMarker& order, std::span<const Slot> slots, const LabelPrices& prices,
             const std::stop_token& stop)
      : fits_{order.marker, slots, stop}, prices_{prices} {
    for (const auto* list : {&order.marker.pieces, &order.marker.unplaced}) {
      for (const Piece& piece : *list) {
        const Shape& shape = order.marker.shapes[piece.shape.value];
        shapes_.push_back(piece.shape);
        pieces_.push_back(compared(label_of(order, pieces_.size()), shape.id, shape_area(shape)));
      }
    }
    for (std::size_t k = 0; k < slots.size(); ++k) {
      slots_.push_back(compared(slots[k].label, slots[k].shape, fits_.slot_area(k)));
    }
  }

  // When cancelled, some of them are 0.
  [[nodiscard]] Costs costs(const std::stop_token& stop) const {
    Costs costs{pieces_.size(), slots_.size()};
    for (std::size_t piece = 0; piece < pieces_.size() && !stop.stop_requested(); ++piece) {
      for (std::size_t slot = 0; slot < slots_.size(); ++slot) costs(piece, slot) = cost(piece, slot);
    }
    return costs;
  }
  [[nodiscard]] std::size_t pieces() const { return pieces_.size(); }
  [[nodiscard]] std::size_t slots() const { return slots_.size(); }
  [[nodiscard]] Fit fit(std::size_t piece, std::size_t slot) const { return fits_.best(shapes_[piece], slot); }
  [[nodiscard]] double piece_area(std::size_t piece) const { return pieces_[piece].area; }
  [[nodiscard]] double slot_area(std::size_t slot) const { return slots_[slot].area; }

 private:
  [[nodiscard]] Compared compared(const Label& label, const std::string& id, double area) {
    return {names_(label.name), sizes_(label.size), ids_(id), area};
  }
  [[nodiscard]] double cost(std::size_t piece, std::size_t slot) const {
    const Compared &a = pieces_[piece], &b = slots_[slot];
    const double shapes = fit(piece, slot).cost;
    const bool named = a.name != 0 && b.name != 0;
    const double price = (differ(a.name, b.name) ? prices_.name : 0) + (differ(a.size, b.size) ? prices_.size : 0);
    return shapes * (named || a.id == b.id ? 1 : kOtherId) + price * (a.area + b.area) / 2;
  }

  const FitTable fits_;
  const LabelPrices& prices_;
  Numbered names_, sizes_, ids_;
  std::vector<ShapeId> shapes_;  // by piece
  std::vector<Compared> pieces_, slots_;
};

}  // namespace

Pairing pair_pieces(const LabelledMarker& order, std::span<const Slot> slots, const LabelPrices& prices,
                    const std::stop_token& stop) {
  const Comparison comparison{order, slots, prices, stop};
  if (stop.stop_requested()) return {};
  const Assignment assignment = assign(comparison.costs(stop), stop);
  if (stop.stop_requested()) return {};
  Pairing pairing;
  std::vector<bool> taken(comparison.slots());
  for (std::size_t piece = 0; piece < comparison.pieces(); ++piece) {
    const double area = comparison.piece_area(piece);
    auto& pair = pairing.pairs.emplace_back();
    if (const auto slot = assignment.column_of[piece]) {
      const Fit fit = comparison.fit(piece, *slot);
      if (fit.difference <= kUnlike * (area + comparison.slot_area(*slot)) / 2) {
        pair = Pair{*slot, fit.orientation};
        pairing.difference += fit.difference;
        taken[*slot] = true;
      }
    }
    if (!pair) pairing.difference += area;
  }
  for (std::size_t slot = 0; slot < comparison.slots(); ++slot) {
    if (!taken[slot]) pairing.difference += comparison.slot_area(slot);
  }
  return pairing;
}

}  // namespace selvage::matching
