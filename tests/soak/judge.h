// The judge of the soak: is a marker valid, and did a motion keep what every motion keeps?  Exact, and independent of
// what Selvage proves its answers with: of the core it takes a marker's values and the outlines it rounded to the
// lattice, and those it compares with the shapes themselves.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/marker/marker.h"

namespace selvage::test {

// What a motion may do, besides moving pieces that are free and may move.
struct Leave {
  Coord longest{};                    // the answer may be this long at most
  bool tilts{};                       // pieces that are wholly free may tilt within their limit
  std::optional<Angle> tilt_limit{};  // in place of the shapes' own, which the answer then has
  bool turns{};                       // pieces may change to another of their shape's rotations
};

class Judge {
 public:
  // What is wrong with the marker, in words; empty when it is valid.  REQUIRES: every marker judged has the same
  // shapes, but for their tilt limits.
  [[nodiscard]] std::string fault_of(const Marker& marker);
  // What a motion broke; empty when it did nothing but what it may.  Does not say whether `after` is valid.
  [[nodiscard]] std::string broken_promise(const Marker& before, const Marker& after, const Leave& leave);
  // Where the rightmost piece ends.
  [[nodiscard]] Coord length_of(const Marker& marker);

 private:
  struct Cut {
    Polygon outline;
    Box box;
    std::string fault;  // it is not the shape in its orientation
  };
  const Cut& cut_of(const Marker& marker, const Piece& piece);

  std::map<std::pair<ShapeId, Orientation>, Cut> cuts_;
};

}  // namespace selvage::test
