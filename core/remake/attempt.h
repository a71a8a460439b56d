// An attempt: one arrangement is taken over, from the substitution to the finished marker, and every step is kept for
// the report and for drawings.
//
// A draft takes a fraction of a second:
//     substitute; relieve columns; remove the overlaps; compact
//     put the pieces in that had no slot, larger first; compact
// It may then be tilted: compacted with small tilts of the pieces.  It is finished by
//     searching for a shorter marker for a while, from the draft as it was without these tilts (core/nesting)
//     taking small pieces out and putting them where there is room; `fine`: swapping and tilting
// Units: lattice units.
#pragma once

#include <optional>
#include <vector>

#include "core/remake/overlap_removal.h"
#include "core/remake/substitution/choice.h"
#include "core/remake/substitution/tuning.h"
#include "core/scene/run.h"

namespace selvage::remake {

using substitution::Candidate;

// What a step did; the order is that of an attempt.
enum class StepKind {
  kSubstituted,  // pieces lie in the slots; they may overlap
  kSeparated,    // overlaps removed by linear programs,
  kPopped,       // by popping trims out and putting them back,
  kSearched,     // by a guided local search
  kCompacted,    // when nothing overlapped any more
  kInserted,     // pieces without a slot were put into gaps or at the end, then compacted
  kTilted,       // small tilts have made it shorter
  kRearranged,   // a short search that has found a shorter marker
  kTrimsMoved,   // small pieces went elsewhere
  kRefined,      // accuracy fine
};

struct Step {
  StepKind kind{};
  std::size_t pieces{};  // that were swapped between slots, popped, or inserted
  Coord length{};        // of the marker after the step
  bool valid{};
  std::vector<Piece> placed;  // as they lie after the step
};

struct Attempt {
  std::vector<std::size_t> stored;  // the markers whose arrangement it took over
  double difference{};              // between the pieces, a part of the order's area
  double predicted{};               // utilisation, 0..1
  double used{};                    // the utilisation of the stored markers, 0..1
  std::vector<Step> steps;
  std::optional<Marker> marker;  // valid, with all pieces; none: they did not come apart, or the cloth ends before them
  int programs{};
};

struct AttemptSettings {
  bool trims{true};  // move small pieces in the end
  bool fine{};       // search for longer, then swap and tilt as accuracy fine does
  RemakeTuning tuning{};
};

struct Draft {
  Attempt attempt;
  std::optional<Marker> marker;  // valid, on cloth without an end; none: the pieces did not come apart
  std::optional<Marker> loose;   // that marker before it was tilted; none: it was not
};

// Laws of drafts, tilted or not, and of finished attempts.  (1) The marker is valid, proved in integers, and has the
// order's pieces in the order's sequence: first the placed ones, then those that were not.  (2) For an order that is
// the stored marker's own, it is no longer than that marker.  (3) A tilted marker and a finished one are no longer than
// their draft.  (4) Deterministic, whatever the cache holds; when cancelled, the best so far.
[[nodiscard]] Draft drafted(const Marker& order, const Candidate& candidate, const AttemptSettings& settings,
                            const scene::Run& run, Removal removal = Removal::kAnyWay);
// The draft with small tilts, where they shorten its marker; once they were tried, they are not tried again.
[[nodiscard]] Draft tilted(const Marker& order, Draft draft, const AttemptSettings& settings, const scene::Run& run);
// How a draft is finished.
enum class Search {
  kNone,
  kShort,  // a few moves
  kWhole,  // as many as the number of pieces demands; then trims are moved
};
[[nodiscard]] Attempt finished(const Marker& order, Draft draft, Search search, const AttemptSettings& settings,
                               const scene::Run& run);

// By how much less the draft's marker uses the cloth than the stored one, 1 when it has no marker; below 0 when it uses
// it better.
[[nodiscard]] double loss_of(const Draft& draft);

}  // namespace selvage::remake
