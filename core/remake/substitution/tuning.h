// The tuning constants of remaking.  Lengths are parts of the strip's width and areas parts of the order's area unless
// said otherwise.  Where no other source is named, the values come from docs/measurements/searches/remaking.md.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/matching/label.h"

namespace selvage::remake::substitution {

struct RemakeTuning {
  // Which stored markers are near enough:
  double farthest{0.5};          // the pairs of their pieces differ by at most this part of the order's area
  double difference_price{0.4};  // predicted loss of utilisation for a unit of difference, beside that of the area
  double least_area{0.8};        // stored area relative to the order's; smaller markers are parts of concatenations
  double most_area{1.25};
  // Of pieces with the places of stored ones, and of shapes in each way in which they may lie: more take gigabytes.
  std::size_t most_compared{25'000'000};
  // Substitution:
  matching::LabelPrices labels{};  // of names and sizes that differ
  double ambiguous{1.15};          // orientations that cost at most this factor more are judged by their overlaps
  std::size_t column_swaps{24};    // of pieces that are alike, until columns fit across the strip
  double column_cell{0.002};       // sampling of outlines along x
  double column_slip{0.02};        // pieces that share less of x than this may pass each other
  double swap_price{0.25};         // a swap may cost at most this part of the swapped pieces' area
  // Coming apart:
  double growth{0.04};               // part of its length by which separation may lengthen the marker
  int separation_rounds{12};         // at most
  int separation_patience{8};        // rounds without progress before separation gives up
  double separation_hopeless{0.02};  // it also gives up when its first two rounds leave depths that add up to more
  double trim{0.35};                 // of the mean area of the pieces: larger ones are popped after smaller ones
  std::size_t first_pops{1};         // pieces popped at most, before the search,
  std::size_t pops{6};               // and after it has failed
  double popped_growth{0.02};        // part of its length: when popping makes the marker longer, a search is tried, too
  double same_spot{0.002};           // shrunken copies this near to each other are restored only once
  // The guided local search, when linear programs cannot part the pieces.  Pieces that are larger than the stored ones
  // never come apart in the marker's own length, and finding that out costs more than all that follows.
  double first_growth{0.03};    // part of its length by which the marker grows before the first search,
  double search_growth{0.015};  // and before each of the others, unless the one before has left a loss of at most
  double few_overlaps{0.2};     // this: then the marker becomes longer by that loss, at the piece that overlaps most;
  int searches{12};             // this many at most
  std::size_t search_patience{60}, search_strikes{1};
  // Afterwards:
  int tilt_rounds{3};        // of small tilts: the first ones give nearly all of what many would
  double hopeless{0.02};     // utilisation below that of the stored marker from which on drafts are searched untilted
  double near_enough{0.01};  // utilisation below that of the stored marker at which no other one is tried,
  double as_good{0.003};     // and at which this one is neither tilted nor searched
  // The search for a shorter marker.  From a draft that is not near enough it makes `moves_per_piece` moves for each
  // piece, or as many as `work` allows, if that is more; from one that is near enough, as many as `short_work` allows.
  // Work is moves times pieces, because a move takes longer the more pieces there are.  A search that would have fewer
  // moves than pieces is left out.
  std::uint64_t moves_per_piece{40}, work{400'000}, short_work{100'000};
  std::uint64_t fine_factor{4};      // with `fine`, this many times the moves
  std::uint64_t untilted_factor{2};  // where no piece may tilt, this many times `moves_per_piece`: tilts take as long
  std::uint64_t fewest_pieces{25};   // orders of fewer are searched as if they had as many
  std::size_t bold_patience{20};     // nesting::NestTuning::bold_patience of this search
  double first_step{0.01};           // part of its length by which this search shortens the marker at first
  double stretch{2};                 // of this search and the one above: nesting::local_search::SearchTuning::stretch
  std::uint64_t trim_trials{1};      // of putting small pieces into gaps (core/packing/refitting/fill_gaps.h)
  friend bool operator==(const RemakeTuning&, const RemakeTuning&) = default;
};

}  // namespace selvage::remake::substitution
