// Floating: the free space of a marker shared out among the gaps between its pieces, so that a knife has room to pass,
// at no cost in cloth [Li94 chapter 7].  The pieces move all at once; widths of gaps are columns of the linear program.
//
// Laws.  (1) The answer is valid, proved in integers.  (2) It is never longer than the input, but for what healing says
// it had to grow by.  (3) The least distance, in whole lattice units, is never smaller than before; `least_after` is
// proved. (4) Locked pieces stay to the lattice unit.  (5) Same input and settings, same answer, whatever the cache
// holds.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/lp/solver/solve.h"
#include "core/motion/floating/float_program.h"
#include "core/motion/floating/tuning.h"
#include "core/motion/repair/motion_result.h"

namespace selvage::motion::floating {

struct FloatSettings {
  FloatMode mode{};
  Coord distance{};  // lattice units: the one wanted by kGivenDistance; for the other modes, wider gaps count as this
                     // wide
  bool edges{};      // gaps to the strip's edges count too; its right edge is the end of the marker as it comes in
  int rounds{};      // at most this many, in each stage
  int stages{};      // of kTwoStep: so often, gaps that hold the minimum are left behind
  double least_gain{};  // the last round is the one that gains less than this part of the width
  double trust{};       // no piece moves farther in a round than this part of the width, on either axis
  lp::solver::SolverChoice solver{};
  FloatTuning tuning{};
  friend bool operator==(const FloatSettings&, const FloatSettings&) = default;
};
// With the distance given, the rest as it should be.
[[nodiscard]] FloatSettings float_settings(FloatMode mode, Coord distance);

struct GapWidths {
  Gap gap;
  double before{}, after{};  // lattice units, exact but for rounding to a double
  friend bool operator==(const GapWidths&, const GapWidths&) = default;
};

// Gaps that cannot all become wider than the distance without the marker becoming longer [Li94 7.6], as far as rounds
// of linear programs can tell.
struct CriticalSet {
  double distance{};      // lattice units
  std::vector<Gap> gaps;  // sorted
  friend bool operator==(const CriticalSet&, const CriticalSet&) = default;
};

struct Floating : repair::MotionResult {
  Coord least_before{}, least_after{};  // the narrowest gap, whole lattice units, at most the setting's distance
  bool reached{};                       // the narrowest gap has the setting's distance
  std::vector<GapWidths> gaps;          // narrower than the setting's distance before or after, sorted
  // What holds the minimum: gaps that carry load in the last program, or, in the modes that do not ask for the minimum,
  // that have it.  kTwoStep adds the sets that held its later stages.  None when the distance is reached.
  std::vector<CriticalSet> critical;
};

// Gaps between two locked pieces do not count.
// Errors: those of heal; kOutOfRange for a distance that is not positive or beyond the lattice.
[[nodiscard]] Result<Floating> float_apart(const Marker& start, const FloatSettings& settings, const scene::Run& run);

}  // namespace selvage::motion::floating
