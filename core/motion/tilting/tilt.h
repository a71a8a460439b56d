// Compaction with small tilts [Li94 chapter 6], by linearisation (6.2) or by relaxation (6.1.3).
//
// By linearisation, rounds of: one linear program that moves and turns all pieces at once, by at most a fraction of a
// degree; smaller ones that correct what its errors of second order left overlapping; separation of the rest;
// translational compaction.  Steps that no longer gain are halved.  By relaxation, rounds of: every piece, one after
// another, to the tilt and the place where it has most room; translational compaction.  When nothing gains any more, a
// shake may push and turn the pieces at random within the same length, for the rounds to begin again.
//
// Laws.  (1) The answer is valid, proved in integers.  (2) It is never longer than the input, but for what healing says
// it had to grow by; nor than compaction alone makes it.  (3) Locked pieces keep place and tilt, to the lattice unit
// and the last bit.  (4) No piece is tilted beyond its limit, but for those that came so, which tilt no farther.
// (5) Every piece is its original shape in its orientation, rounded once, however many rounds turned it.  (6) Same
// input and settings, same answer, whatever the cache holds.
#pragma once

#include <optional>

#include "core/base/result.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/tilting/tuning.h"

namespace selvage::motion::tilting {

enum class TiltMethod {
  kLinearisation,  // [Li94 6.2]
  kRelaxation,     // [Li94 6.1.3]
};

struct TiltSettings {
  TiltMethod method{};
  std::optional<Angle> limit{};  // in place of every shape's own; the answer's shapes have it
  int rounds{};                  // at most this many
  double least_gain{};           // rounds that gain less than this part of the width have converged
  Angle step{};                  // linearisation: no piece turns farther in a round
  double trust{};                // linearisation: nor moves farther on an axis, as a part of the width
  int tilts{};                   // relaxation: so many tilts are tried, evenly spaced from limit to limit
  int perturbations{};           // so often the pieces are shaken
  compaction::CompactionSettings compaction{};
  TiltTuning tuning{};
  friend bool operator==(const TiltSettings&, const TiltSettings&) = default;
};
[[nodiscard]] TiltSettings tilt_settings(TiltMethod method, compaction::Accuracy accuracy);

// `programs` leaves out those of separation.
struct Tilting : compaction::Compaction {
  Coord length_compacted{};  // after translational compaction, before any piece was tilted
  Angle farthest_tilt{};     // the largest |tilt| of a piece of the answer
};

// Errors: those of heal; kOutOfRange for a limit that is not from 0 to 45 degrees.
[[nodiscard]] Result<Tilting> tilt(const Marker& start, const TiltSettings& settings, const scene::Run& run);

}  // namespace selvage::motion::tilting
