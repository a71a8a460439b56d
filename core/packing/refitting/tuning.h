// The tuning constants of refitting.  Values without another source were tuned on the example markers
// (docs/measurements/searches/packing.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace selvage::packing::refitting {

struct GapTuning {
  double small{0.8};  // the part of the pieces, from the smallest, that are taken out
  double near{1};     // pieces are taken out together when their middles are this near along the strip, in widths
  // Of the length that the other pieces give up: how much of it the refitted pieces may use, tried one after another
  // while they fit.
  std::array<double, 2> parts{0.97, 0.3};
  double least_gain{1e-5};      // of the others when pieces are taken out, in widths
  std::uint64_t any_one_in{4};  // one trial in this many begins with any small piece, the others with a critical one
  friend bool operator==(const GapTuning&, const GapTuning&) = default;
};

struct WindowTuning {
  double shift{5e-4};              // by which the pieces behind a window must come nearer, in widths
  std::uint64_t first_nodes{300};  // of the searches in windows, the first time that they slide over the marker;
  std::uint64_t growth{4};         // this many times as many each time after that
  std::size_t more_pieces{3};      // by which windows are larger every second time
  friend bool operator==(const WindowTuning&, const WindowTuning&) = default;
};

}  // namespace selvage::packing::refitting
