// The judge of the soak test: checks whether a marker is valid, and whether a motion changed only what it may change.
//
// The judge is exact and independent of the code with which Selvage proves its results.  From the core it takes only
// marker values and the outlines rounded to the lattice, and it compares those with the shapes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/marker/marker.h"

namespace selvage::test {

// What a motion may change besides the positions of pieces that are free to move.
struct Leave {
  Coord longest{};                    // the largest length allowed for the result
  bool tilts{};                       // pieces without locks may tilt within their limit
  std::optional<Angle> tilt_limit{};  // replaces the shapes' tilt limits; the result then has this limit
  bool turns{};                       // pieces may change to another allowed rotation of their shape
  bool flips{};                       // pieces may be mirrored if their shapes allow it
};

class Judge {
 public:
  // A description of what is wrong with the marker; empty when it is valid.
  // REQUIRES: all markers given to one judge have the same shapes, apart from tilt limits.
  [[nodiscard]] std::string fault_of(const Marker& marker);
  // A description of what the motion changed without being allowed to; empty when there is nothing.  Does not check
  // whether `after` is valid.
  [[nodiscard]] std::string broken_promise(const Marker& before, const Marker& after, const Leave& leave);
  // The x coordinate at which the rightmost piece ends.
  [[nodiscard]] Coord length_of(const Marker& marker);

 private:
  struct Cut {
    Polygon outline;
    Box box;
    std::string fault;  // how the outline differs from the shape in its orientation; empty when it does not
  };
  const Cut& cut_of(const Marker& marker, const Piece& piece);

  std::map<std::pair<ShapeId, Orientation>, Cut> cuts_;
};

}  // namespace selvage::test
