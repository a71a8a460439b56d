#include "core/remake/substitution/arrangement.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace selvage::remake::substitution {
namespace {

// From one resolution to another: exact to a finer one, rounded to a coarser one.
class Scale {
 public:
  Scale(Resolution from, Resolution to) : factor_{std::pow(10.0, from.exponent - to.exponent)} {}

  [[nodiscard]] bool holds(double extent) const { return extent * factor_ < static_cast<double>(kLatticeLimit) / 4; }
  [[nodiscard]] Coord operator()(Coord value) const {
    return factor_ == 1 ? value : std::llround(static_cast<double>(value) * factor_);
  }
  [[nodiscard]] Vec operator()(Vec v) const { return {(*this)(v.x), (*this)(v.y)}; }
  [[nodiscard]] Polygon operator()(Polygon outline) const {
    for (Vec& v : outline) v = (*this)(v);
    outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
    return outline;
  }

 private:
  double factor_;
};

}  // namespace

std::optional<Arrangement> arrangement_of(const matching::LabelledMarker& labelled, std::size_t number,
                                          Resolution resolution) {
  const Marker& stored = labelled.marker;
  if (stored.pieces.empty()) return std::nullopt;
  const Scale scaled{stored.resolution, resolution};
  const Coord length = length_of(stored);
  if (!scaled.holds(static_cast<double>(std::max(length, stored.strip.width)))) return std::nullopt;
  Arrangement arrangement{.stored = {number}, .slots = {}, .length = scaled(length), .area = 0};
  for (std::size_t k = 0; k < stored.pieces.size(); ++k) {
    const Piece& piece = stored.pieces[k];
    const Shape& shape = stored.shapes[piece.shape.value];
    matching::Slot slot = matching::slot_of(shape, piece.orientation, scaled(piece.at));
    slot.label = label_of(labelled, k);
    for (Polygon* outline : {&slot.outline, &slot.untilted}) *outline = scaled(std::move(*outline));
    if (doubled_area(slot.outline) <= 0) continue;  // nothing is left of it on a coarse lattice
    arrangement.area += geometry::area_of(slot.outline);
    arrangement.slots.push_back(std::move(slot));
  }
  return arrangement;
}

std::optional<Arrangement> concatenated(const Arrangement& first, const Arrangement& second) {
  if (first.length + second.length >= kLatticeLimit / 4) return std::nullopt;
  Arrangement both = first;
  both.stored.insert(both.stored.end(), second.stored.begin(), second.stored.end());
  for (matching::Slot slot : second.slots) {
    slot.at.x += first.length;
    both.slots.push_back(std::move(slot));
  }
  both.length += second.length;
  both.area += second.area;
  return both;
}

}  // namespace selvage::remake::substitution
