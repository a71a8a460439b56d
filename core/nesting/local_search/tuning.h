// The tuning constants of the guided local search.  Lengths are in model units unless said otherwise.
#pragma once

#include <cstddef>

namespace selvage::nesting::local_search {

struct SearchTuning {
  double charge{5};               // added to the depth of every overlap: to touch at all costs something
  double pixels_per_side{8};      // grid cells along the side of a square as large as the mean piece
  double tolerance{0.02};         // depths up to this count as none: repair removes them
  std::size_t best_places{3};     // places of the field that a move examines closely
  std::size_t rows_per_place{5};  // rows of the field that are looked at for each of them
  double apart{3.5};              // pixels between two of those places
  // Widths: in a longer layout, bold attempts shorten one stretch of this length, and a move looks no farther than half
  // of it to either side.
  double stretch{6};
  std::size_t costly_fields{300};  // with this many pieces times orientations or more, a move skips most orientations
  // Descents, in pixels except the limits of exact ones: from, and down to, steps of this size.
  double stay_step{0.5}, rough_step{0.7}, fine_step{0.2};
  double rough_limit{0.5}, fine_limit{0.1}, last_step{0.1}, last_limit{0.01};
  double hopeless{1.15};      // rough losses above this multiple of the best one are not refined
  double weight_growth{1.2};  // of a pair that overlaps, each iteration,
  double extra_growth{0.8};   // plus this part for the deepest one, less for others
  double weight_decay{0.95};  // of a pair that does not overlap
  double progress{0.98};      // an iteration makes progress when at most this part of the loss is left
  std::size_t patience{200};  // iterations without progress end a strike
  std::size_t strikes{3};     // strikes in a row end a separation
  friend bool operator==(const SearchTuning&, const SearchTuning&) = default;
};

}  // namespace selvage::nesting::local_search
