#include "core/matching/pairing.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "core/matching/assignment.h"
#include "core/matching/silhouette.h"

namespace selvage::matching {
namespace {

constexpr double kOtherName = 1.05;  // factor on the cost of shapes whose ids differ
constexpr double kGrowth = 1;        // weight of growth across the strip, relative to the difference

// A shape in each of the orientations that are tried, drawn once.
struct Drawn {
  Orientation orientation;
  Silhouette silhouette;
};

// Slots with the same outline and orientation are alike.
using SlotKey = std::tuple<std::string, Orientation, std::uint64_t>;

class Fitting {
 public:
  Fitting(const Shape& shape, const Orientation& slot) {
    for (const Orientation& orientation : orientations_of(shape, slot)) {
      drawn_.push_back({orientation, silhouette_of(oriented(shape.outline, orientation))});
    }
  }

  // In each orientation, the cheapest first.
  [[nodiscard]] std::vector<Fit> into(const Silhouette& slot, bool same_name) const {
    std::vector<Fit> fits;
    for (const auto& [orientation, silhouette] : drawn_) {
      const double difference = estimated_difference(silhouette, slot);
      const double growth = std::max(0.0, silhouette.height - slot.height) * (silhouette.width + slot.width) / 2;
      fits.push_back({(difference + kGrowth * growth) * (same_name ? 1 : kOtherName), difference, orientation});
    }
    std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.cost < b.cost; });
    return fits;
  }

 private:
  std::vector<Drawn> drawn_;
};

// The fits of every shape into every kind of slot.
class FitTable {
 public:
  FitTable(const Marker& order, std::span<const Slot> slots) {
    std::map<SlotKey, std::size_t> kinds;
    std::vector<const Slot*> firsts;
    for (const Slot& slot : slots) {
      Silhouette silhouette = silhouette_of(slot.outline);
      const auto [kind, fresh] =
          kinds.try_emplace({slot.shape, slot.orientation, silhouette.hash}, silhouettes_.size());
      kind_of_.push_back(kind->second);
      if (!fresh) continue;
      silhouettes_.push_back(silhouette);
      firsts.push_back(&slot);
    }
    for (const Shape& shape : order.shapes) {
      std::map<Orientation, Fitting> fittings;  // without tilts in the slots, there is one for each rotation at most
      std::vector<Fit>& fits = fits_.emplace_back();
      for (std::size_t k = 0; k < firsts.size(); ++k) {
        const Orientation as_tried =
            shape.rotations.empty() ? firsts[k]->orientation : Orientation{{}, {}, firsts[k]->orientation.tilt};
        const auto fitting = fittings.try_emplace(as_tried, shape, as_tried).first;
        fits.push_back(fitting->second.into(silhouettes_[k], shape.id == firsts[k]->shape).front());
      }
    }
  }

  [[nodiscard]] const Fit& operator()(ShapeId shape, std::size_t slot) const {
    return fits_[shape.value][kind_of_[slot]];
  }
  [[nodiscard]] double slot_area(std::size_t slot) const { return silhouettes_[kind_of_[slot]].area; }

 private:
  std::vector<std::size_t> kind_of_;  // by slot
  std::vector<Silhouette> silhouettes_;
  std::vector<std::vector<Fit>> fits_;  // by shape and kind
};

double shape_area(const Shape& shape) {
  return static_cast<double>(doubled_area(shape.outline)) / 2;
}

}  // namespace

std::vector<Orientation> orientations_of(const Shape& shape, const Orientation& slot) {
  std::vector<Angle> rotations = shape.rotations;
  if (rotations.empty()) {
    for (const double quarter : {0.0, 90.0, 180.0, 270.0}) rotations.push_back({slot.rotation.degrees + quarter});
  }
  std::vector<Angle> tilts{Angle{}};
  const double tilt = slot.tilt.degrees;
  if (tilt != 0 && std::max(tilt, -tilt) <= shape.tilt_limit.degrees) tilts.push_back(slot.tilt);
  std::vector<Orientation> all;
  for (const bool flip : {false, true}) {
    if (flip && !shape.may_flip) continue;
    for (const Angle rotation : rotations) {
      for (const Angle own : tilts) all.push_back({flip, rotation, own});
    }
  }
  return all;
}

std::vector<Fit> fits_of(const Shape& shape, const Slot& slot) {
  return Fitting{shape, slot.orientation}.into(silhouette_of(slot.outline), shape.id == slot.shape);
}

Pairing pair_pieces(const Marker& order, std::span<const Slot> slots) {
  std::vector<const Piece*> pieces;
  for (const auto* list : {&order.pieces, &order.unplaced}) {
    for (const Piece& piece : *list) pieces.push_back(&piece);
  }
  const FitTable fits{order, slots};
  Costs costs{pieces.size(), slots.size()};
  for (std::size_t row = 0; row < pieces.size(); ++row) {
    for (std::size_t column = 0; column < slots.size(); ++column) {
      costs(row, column) = fits(pieces[row]->shape, column).cost;
    }
  }
  const Assignment assignment = assign(costs);
  Pairing pairing;
  std::vector<bool> taken(slots.size());
  for (std::size_t row = 0; row < pieces.size(); ++row) {
    const double area = shape_area(order.shapes[pieces[row]->shape.value]);
    auto& pair = pairing.pairs.emplace_back();
    if (const auto column = assignment.column_of[row]) {
      const Fit& fit = fits(pieces[row]->shape, *column);
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
