// How well the shapes of an order fit the slots of a stored marker.
//
// A slot is the place of a piece in a marker that is to be taken over.  What a piece costs in a slot is the estimated
// area in which their silhouettes differ, in one of the orientations that the piece's shape allows, and the growth
// across the strip counts again: pieces stacked across the cloth that become taller do not fit its width any more,
// whereas smaller ones leave a gap (docs/measurements/searches/remaking.md).  What pieces are called is counted
// separately (pairing.h).  Tilts are not counted: silhouettes are compared without them, and a piece takes the slot's
// tilt where its shape allows it.
// Units: lattice units and square lattice units of the order's resolution.
#pragma once

#include <cstddef>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/marker/marker.h"
#include "core/matching/label.h"
#include "core/matching/silhouette.h"

namespace selvage::matching {

struct Slot {
  std::string shape;        // its id
  Polygon outline;          // in its orientation, at position 0
  Polygon untilted;         // in its orientation but for the tilt
  Orientation orientation;  // of the piece that lies there
  Vec at;                   // of the outline
  Label label;              // of that piece
};
// The slot of a piece of this shape, without a label.
[[nodiscard]] Slot slot_of(const Shape& shape, const Orientation& orientation, Vec at);

// The orientations in which a piece of the shape is tried in a slot: all rotations and flips that the shape allows,
// with the slot's tilt where it allows that.  A shape that may turn freely tries the slot's rotation and quarter turns.
// The slot's own orientation comes first, if it is among them: of those that look the same, a piece takes this one,
// since others would be rounded to the lattice in another way.
[[nodiscard]] std::vector<Orientation> orientations_of(const Shape& shape, const Orientation& slot);

struct Fit {
  double cost{}, difference{};
  Orientation orientation;
};

// The fits of every shape of an order into every slot.  Slots that are alike are compared once.  When cancelled, there
// are no fits of some shapes: a caller that may be cancelled looks at the token before it asks for any.
class FitTable {
 public:
  FitTable(const Marker& order, std::span<const Slot> slots, const std::stop_token& stop = {});

  // One for each orientation of the shape, the cheapest first; of equally cheap ones, the slot's own first.
  [[nodiscard]] std::vector<Fit> all(ShapeId shape, std::size_t slot) const;
  [[nodiscard]] Fit best(ShapeId shape, std::size_t slot) const;
  [[nodiscard]] double slot_area(std::size_t slot) const { return kinds_[slots_[slot].kind].area; }

 private:
  // A tilt that pieces in the slot take over, and what the slot is compared as.
  struct Place {
    Angle tilt;
    std::size_t kind{};
  };
  [[nodiscard]] Fit tilted(Fit fit, ShapeId shape, std::size_t slot) const;

  std::vector<Place> slots_;
  std::vector<Silhouette> kinds_;
  std::vector<Angle> tilt_limits_;                   // by shape
  std::vector<std::vector<std::vector<Fit>>> fits_;  // by shape and kind, without tilts
};

}  // namespace selvage::matching
