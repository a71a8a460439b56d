// Labels: what a piece is called and which size it has, as far as that is known [Li94 5.3.2].
//
// They support the comparison of shapes and never replace it: where two pieces have names or sizes that differ, they
// count as if a part of their area differed, too.  So labels decide between shapes that fit about equally well, and
// shapes decide against labels as soon as they differ by more than that part.
// Units: prices are parts of the mean area of the two pieces; their values come from
// docs/measurements/searches/remaking.md.
#pragma once

#include <string>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::matching {

// Equal pieces of different sizes have the same name.  Labels are compared character by character.
struct Label {
  std::string name, size;  // empty: not known
  friend bool operator==(const Label&, const Label&) = default;
};

// A marker or an order with the labels of its pieces, first those of the placed ones, then of the unplaced ones; those
// beyond the end of the list have none.
struct LabelledMarker {
  Marker marker;
  std::vector<Label> labels;
};
// REQUIRES: `piece` counts the placed pieces first, then the unplaced ones.
[[nodiscard]] Label label_of(const LabelledMarker& marker, std::size_t piece);

struct LabelPrices {
  double name{0.02};  // of a piece that lies where another name lay
  double size{0.01};  // of a piece that lies where another size lay
  friend bool operator==(const LabelPrices&, const LabelPrices&) = default;
};

}  // namespace selvage::matching
