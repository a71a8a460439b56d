// Refinement: compaction for when length matters more than time; this is accuracy `fine` of a whole marker.
//
// First standard compaction.  Then compaction from the same start with other region rules, trust radii and weights of
// gravity, because a descent's end depends on its path.  Then nesting from where the best of these has the pieces
// (renesting.h).  Then, where shapes allow tilts, tilting of the result and of the start (core/motion/tilting/tilt.h).
// Finally swaps of pieces (swap_search.h), alternately in the best marker without new tilts, which is tilted again when
// it has become shorter, and in the best marker of all.  The search ends when it is predicted to gain little more
// (effort.h).  A marker that ends with a locked piece, or is full, is not searched.
//
// Laws.  (1) The answer is valid, proved in integers.  (2) It is never longer than the answers of standard compaction
// and, where tilts are allowed, of standard tilting, unless cancelled before that was done, and never longer than the
// input, except by what the repair of the input reports.  (3) Locked pieces stay in place to the lattice unit, groups
// stay rigid, tilts, rotations and flips are those that shapes allow.  (4) The same input and settings give the same
// answer, whatever the cache holds and however many threads are used.  (5) When cancelled, it returns the best marker
// so far.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/base/result.h"
#include "core/motion/compaction/compact.h"
#include "core/search/tuning.h"

namespace selvage::search {

struct RefineSettings {
  int variants{};          // number of other region rules, trust radii and weights of gravity tried, at most 4
  std::uint64_t effort{};  // the search ends when the number of pieces, summed over all programs solved, reaches this
                           // (a move of nesting counts as some pieces),
  std::uint64_t least_effort{effort};  // and from this much on when little more is to be gained (effort.h)
  bool tilts{};                        // tilt pieces where shapes allow it
  bool nests{};                        // nest the pieces anew, from where they lie (renesting.h)
  // The part of the caller's time that is used up, 0..1, for a caller that limits time; the run has to be stopped when
  // it reaches 1.
  std::function<double()> elapsed{};
  std::uint32_t seed{};                                 // of nesting and of the random swaps
  std::size_t most_pieces_swapped{marker::kMaxPieces};  // in markers with more pieces no swaps are tried
  RefineTuning tuning{};
};
// Figures behind these: docs/measurements/trade.md.
[[nodiscard]] RefineSettings refine_settings();

// The search never converges: it stops with kWorkLimit or kCancelled.  A round, in the answer and for the observer, is
// one attempt, whether it gained or not.  Errors: those of repair_overlaps.
[[nodiscard]] Result<motion::compaction::Compaction> refine(const Marker& start, const RefineSettings& settings,
                                                            const scene::Run& run);

}  // namespace selvage::search
