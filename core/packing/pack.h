// Packing: the shortest marker that the pieces allow, whatever the order they lie in [Li94 8.2].
//
// Where compaction stays in one convex part of each pair's free space, packing searches all of them
// (core/packing/branching).  Unplaced pieces are placed, too.  Layouts are looked for up to a ceiling that rises from
// the area of the pieces: every ceiling without a layout is a proved lower bound, and the search under the ceiling that
// has one proves the optimum.  A search that takes long is interrupted from time to time for a nesting (core/nesting),
// so that it has a good layout to beat, and to return.
//
// Laws.  (1) The answer is valid, proved in integers, and never longer than the input when that is valid.  (2) No
// marker of these pieces, in the orientations that are searched, is shorter than `bound`, in exact arithmetic
// (branching/relaxation.h).  (3) Locked pieces stay in place to the lattice unit, groups stay rigid.  (4) The same
// input and settings give the same answer, whatever the cache holds and however many threads are used.  (5) Cancelled
// or at its work limit, it returns the best marker and the best bound so far.  (6) The pieces of a layout that the
// search finds do not overlap: where overlap allowances would let them, nothing is proved, the bound is 0 and the
// reason kWorkLimit, and the answer is the shortest of that layout, the input, and what a compaction and a nesting that
// use the allowances make of it (with_overlaps.h).  (7) An answer that is not proved is compacted.  With kConverged and
// without a proof, the search is over, but some layouts are valid or not only because of rounding or spacings: more
// nodes do not close the gap between the marker and the bound.
#pragma once

#include "core/motion/repair/motion_result.h"
#include "core/packing/branching/search.h"

namespace selvage::packing {

// After how many nodes a search is interrupted for a nesting, and the moves that this may make.  None of it changes
// what the search proves.  The number of nodes is at least 1 in each.
struct InterruptionTuning {
  std::uint64_t first{5'000};          // of the first interruption
  std::uint64_t moves_a_piece{1'000};  // of the first nesting
  std::uint64_t second{50'000};        // of the second interruption; later ones come whenever the nodes have doubled
  std::uint64_t nodes_a_move{2};       // later nestings make a move for so many nodes since the one before
  std::uint64_t moves_at_end{100};     // for each piece, of the nesting after a search that is over and proves nothing
  friend bool operator==(const InterruptionTuning&, const InterruptionTuning&) = default;
};

struct PackSettings {
  branching::WorkLimits limits{};
  // Pieces may take the other orientations that their shapes list; a piece that turns freely keeps the present one.
  bool turns{true};
  double gap{1e-6};  // the search ends when the marker is this near to the bound; a part of the width
  branching::SearchTuning tuning{};
  InterruptionTuning interruptions{};
  friend bool operator==(const PackSettings&, const PackSettings&) = default;
};

struct Packing : motion::repair::MotionResult {
  bool found{};   // there is a layout of all pieces: `marker` is the shortest known; otherwise it is the input
  bool proved{};  // the search is complete: no layout is shorter, but for the gap and rounding, or there is none at all
  Coord bound{};  // no marker of these pieces is shorter; lattice units
  branching::Work work;
};

// The input may overlap.  All pieces keep their rules (core/marker/rules.h); where the layouts that a search finds
// break a shade, it may miss the shortest, and proves no more than its bound.  With more than kMostBodies movable
// pieces (bodies.h), or outlines with too many edges, it ends with kWorkLimit after the first layout.
[[nodiscard]] Packing pack(const Marker& start, const PackSettings& settings, const scene::Run& run);

}  // namespace selvage::packing
