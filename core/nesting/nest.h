// Nesting: places all pieces of a marker, also those that do not lie on the cloth yet, so that the marker is as short
// as the search can make it.
//
// Method.  A guided local search over penetration depths ([UYI+09], [IYN09], [GVW25]) finds layouts that hardly overlap
// in a given length; linear programs ([Li94], core/motion) remove what is left, compact the layout, and prove it; then
// the strip is shortened (exploration.h).  If the cloth ends before all pieces lie on it, the rest of the budget is
// spent on choosing those that do (filling/fill.h).  Finally, pieces are rotated by small angles (finish.h).  What is
// new here: the field of a whole strip, added up from rasterised Minkowski sums (fields/field.h), and the
// compaction after every success.
//
// Laws.  (1) The answer is valid, proved in integers.  (2) Every piece of the input is in the answer, placed or, when
// the cloth ends before it, unplaced.  (3) Locked pieces and pieces of groups stay in place, except for compaction,
// which moves groups as one.  (4) If the input places all pieces and is valid, and the search is not from scratch, the
// answer is no longer than it.  (5) The same input and settings give the same answer, whatever the cache holds and
// however many threads are used; with `elapsed` or when cancelled, the best marker so far.  (6) On a strip without an
// end, more moves never give a longer marker, before pieces tilt and unless they are nested in batches.
// (7) When `elapsed` reaches 1, the linear program that is being solved is the last one.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "core/motion/repair/motion_result.h"
#include "core/nesting/exploration.h"
#include "core/nesting/layout/piece_set.h"
#include "core/nesting/tuning.h"
#include "core/scene/run.h"

namespace selvage::nesting {

struct NestSettings {
  std::uint64_t moves{};    // budget of every search
  std::size_t searches{1};  // the best answer counts; late in a time limit they go on from the best of all
  std::uint64_t seed{};
  bool tilts{true};  // finally tilts pieces, where their shapes allow it (finish.h)
  layout::PlacedPiecesMay placed{layout::PlacedPiecesMay::kMove};
  // Takes all pieces except locked ones and groups off the cloth first: the answer may then be longer than the input.
  bool from_scratch{};
  // The part of the caller's time that is used up, 0..1; empty when only moves are limited.  Called by all threads that
  // work for the nesting.
  std::function<double()> elapsed{};
  // Where the cloth ends before all pieces lie on it: what pieces are worth, by their id; others are worth their area
  // in square lattice units.  At least 0.
  std::map<std::string, double, std::less<>> values{};
  NestTuning tuning{};
};

// `rounds` counts the improvements of the search that the answer is from; `length_before` is that of the placed pieces.
struct Nesting : motion::repair::MotionResult {
  std::uint64_t moves{};             // of all searches
  std::size_t search{};              // the one that the answer is from
  std::vector<Improvement> history;  // of that search
  std::size_t left_over{};           // pieces that are unplaced because the cloth ends
  bool out_of_time{};                // with kWorkLimit: its share of the time ended it, not the moves
};

// More pieces than NestTuning::most_pieces are nested in batches, one after another (batches/batches.h).
// The observer's rounds are the better markers as they are found, by any of the searches: with all pieces, on a strip
// without an end, also where the cloth ends before some of them.
// Errors: kEmptyMarker when there is no piece; kPieceTooWide for a piece that fits the strip, and the room that its
// rules leave (core/marker/rules.h), in no allowed orientation; kMarkerOverlaps and kOutsideStrip when pieces
// that must stay in place do not lie validly; those of start::first_layout, which without rules occur only where pieces
// would reach beyond the lattice.
[[nodiscard]] Result<Nesting> nest(const Marker& start, const NestSettings& settings, const scene::Run& run);

}  // namespace selvage::nesting
