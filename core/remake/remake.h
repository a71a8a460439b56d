// Remaking: a new order is laid out like a stored marker, or like two of them one behind the other [Li94 5.3, 10].
//
// The stored markers whose pieces differ least from the order's are tried (choice.h).  A try is a draft, which takes a
// fraction of a second (attempt.h); when the first is near enough to its stored marker, if need be once it is tilted,
// no other follows.  The shortest draft is finished by a search for a shorter marker.  The search is brief if the draft
// is near enough, and left out if the draft is within a few tenths of a point of its stored marker.
//
// Laws.  (1) The answer is valid, proved in integers, or it is the order as it came in and `outcome` says why.  (2) A
// marker's own order gives at least its utilisation, when that marker is tried and no piece has rules of its own
// (pieces of one shape may take each other's places).  (3) One more stored marker never makes the answer longer when
// all candidates are tried and `thorough` is asked for.  (4) The same input and settings give the same answer, whatever
// the cache holds and however many threads are used; when cancelled, the best marker so far.  (5) More tries never give
// a longer marker when `thorough` is asked for.
// Units: lattice units of the order's resolution.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/matching/label.h"
#include "core/motion/repair/motion_result.h"
#include "core/remake/attempt.h"

namespace selvage::remake {

struct RemakeSettings {
  std::size_t tries{3};    // arrangements tried, best prediction first
  bool concatenate{true};  // also two stored markers, one behind the other
  bool thorough{};         // all tries are made and finished, whatever the first or the shortest draft is like
  bool nest{};             // nest from nothing when no attempt gives a marker
  std::uint64_t nest_moves{20'000};
  AttemptSettings attempt{};
};

enum class Outcome {
  kRemade,    // the marker is that of the attempt `chosen`
  kNested,    // no stored marker was near enough, or nothing came apart; the marker is nested from nothing
  kNoneNear,  // no stored marker is near enough
  kNotApart,  // the pieces of no attempt came apart, or the cloth ends before them
};

// `marker` is the order as it came in unless it was remade or nested.  A round is an attempt.
struct Remake : motion::repair::MotionResult {
  Outcome outcome{};
  std::size_t candidates{};           // arrangements that were near enough
  std::vector<Attempt> attempts;      // by prediction
  std::optional<std::size_t> chosen;  // the attempt that the answer is from
};

// The positions of the order's placed pieces do not matter.  Names and sizes of pieces count where both sides have them
// (core/matching/label.h).
// Errors: kOutOfRange for a zone, for a placed piece that is locked or in a group, and for an unplaced one that may not
// tilt; those of nest, when it is asked for.
[[nodiscard]] Result<Remake> remake(const matching::LabelledMarker& order,
                                    std::span<const matching::LabelledMarker> stored, const RemakeSettings& settings,
                                    const scene::Run& run);

}  // namespace selvage::remake
