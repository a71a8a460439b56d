// The tuning constants of separation.  Prices are per lattice unit, relative to the price 1 of moving a piece by one
// unit on one axis.  Where no other source is named, the values were tuned on the example markers with random overlaps
// of 1 to 5 % of the width (docs/measurements/separation.md).
#pragma once

#include <cstddef>
#include <limits>

namespace selvage::motion::separation {

struct SeparationTuning {
  double overlap_price{100};  // of overlap that stays: high enough that a round removes what it can
  double price_growth{1.4};   // factor on the price of a pair's overlap in every round that it stays
  double highest_price{1e5};  // of any pair's overlap: keeps the programs well scaled
  double length_price{10};    // of the marker becoming longer, up to the allowed length
  double excess_price{50};    // of the marker becoming longer than allowed, which later rounds must take back
  double reach{2};            // pairs within this multiple of the deepest overlap are modelled,
  double least_reach{1e-3};   // but at least within this part of the width,
  double most_reach{0.25};    // and at most within this one
  double rounding{64};        // lattice units: overlaps that are no deeper come from rounding, and rows then regain the
                              // margins that prevent it; before, they keep the room that they have
  int leap_after{2};          // rounds without progress before pieces leap
  double leap_reach{1.5};     // first leaps go up to this multiple of the depth, second ones up to twice that, ...
  int leap_steps{8};          // of the grid that a leap searches, from the present position to either side
  std::size_t many{500};      // in markers with more pieces, only the first round brings pieces back towards where they
                              // were: later ones move what overlaps, and what that presses on, from where it is now
  double tolerance{1e-4};     // of the programs in such markers: pieces may move this part more than necessary
  int patience{30};           // rounds without progress before separation gives up
  double progress{0.95};      // a round makes progress when at most this part of the overlap is left
  // Separation also gives up after this many rounds when all depths that are left, and what lies beyond the allowed
  // length, add up to more than this multiple of the strip's width.
  int hopeless_after{2};
  double hopeless{std::numeric_limits<double>::infinity()};
  friend bool operator==(const SeparationTuning&, const SeparationTuning&) = default;
};

}  // namespace selvage::motion::separation
