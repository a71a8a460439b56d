// Compaction with small tilts [Li94 chapter 6], by linearisation (6.2) or by relaxation (6.1.3).
//
// By linearisation, rounds of: one linear program that moves and turns all pieces at once, by at most a fraction of a
// degree; smaller ones that correct what its errors of second order left overlapping; separation of the rest;
// translational compaction.  Steps that no longer gain are halved.  By relaxation, rounds of: every piece, one after
// another, moves to the tilt and the position where it has most room; translational compaction.  When rounds no longer
// gain, a perturbation may push and turn the pieces at random within the same length, and the rounds start again.
//
// Laws.  (1) The answer is valid, proved in integers.  (2) It is never longer than the input, except by what the repair
// of the input reports, and never longer than compaction alone makes it.  (3) Locked pieces keep their position to the
// lattice unit and their tilt to the last bit.  (4) No piece is tilted beyond its limit, except those that were before,
// which tilt no farther.  (5) Every piece is its original shape in its orientation, rounded once, however many rounds
// turned it.  (6) The same input and settings give the same answer, whatever the cache holds.
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
  std::optional<Angle> limit{};  // replaces the limit of every shape, in the answer, too
  int rounds{};                  // at most this many
  double least_gain{};           // rounds that gain less than this part of the width have converged
  Angle step{};                  // linearisation: no piece turns farther in a round
  double trust{};                // linearisation: no piece moves farther on an axis in a round; part of the width
  int tilts{};                   // relaxation: number of tilt angles sampled, evenly spaced from limit to limit
  int perturbations{};           // number of random restarts
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

// Errors: those of repair_overlaps; kOutOfRange for a limit that is not from 0 to 45 degrees.
[[nodiscard]] Result<Tilting> tilt(const Marker& start, const TiltSettings& settings, const scene::Run& run);

}  // namespace selvage::motion::tilting
