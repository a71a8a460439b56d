// Floating: distributes the free space of a marker among the gaps between its pieces, so that a knife has room to pass,
// at no cost in cloth [Li94 chapter 7].  All pieces move at once; the widths of gaps are columns of the linear program.
//
// Laws.  (1) The answer is valid, proved in integers.  (2) It is never longer than the input, except by what the repair
// of the input reports.  (3) The least distance, in whole lattice units, is never smaller than before; `least_after` is
// proved, but in a motion that was stopped before the narrowest gap was found: there both are 0.  (4) Locked pieces
// stay in place to the lattice unit.  (5) The same input and settings give the same answer, whatever the cache holds.
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
  int stages{};      // of kTwoStep: how many times the gaps that limit the minimum are set aside
  double least_gain{};  // rounds end with the first one that gains less than this part of the width
  double trust{};       // no piece moves farther in a round than this part of the width, on either axis
  lp::solver::SolverChoice solver{};
  FloatTuning tuning{};
  friend bool operator==(const FloatSettings&, const FloatSettings&) = default;
};
// The recommended settings for a mode and a distance.
[[nodiscard]] FloatSettings float_settings(FloatMode mode, Coord distance);

struct GapWidths {
  Gap gap;
  double before{}, after{};  // lattice units, exact but for rounding to a double
  friend bool operator==(const GapWidths&, const GapWidths&) = default;
};

// Gaps that cannot all become wider than the distance unless the marker becomes longer [Li94 7.6], as far as rounds of
// linear programs can determine.
struct CriticalSet {
  double distance{};      // lattice units
  std::vector<Gap> gaps;  // sorted
  friend bool operator==(const CriticalSet&, const CriticalSet&) = default;
};

struct Floating : repair::MotionResult {
  Coord least_before{}, least_after{};  // the narrowest gap, whole lattice units, at most the setting's distance
  bool reached{};                       // the narrowest gap has the setting's distance
  // Narrower than the setting's distance before or after, sorted; only some of them, or none, when the motion was
  // stopped and there are many.
  std::vector<GapWidths> gaps;
  // The gaps that limit the minimum: those that carry load in the last program or, in modes that do not maximise the
  // minimum, those that have it.  kTwoStep adds the sets that limit its later stages.  Empty when the distance is
  // reached.
  std::vector<CriticalSet> critical;
};

// Gaps between two locked pieces do not count.
// Errors: those of repair_overlaps; kOutOfRange for a distance that is not positive or beyond the lattice.
[[nodiscard]] Result<Floating> float_apart(const Marker& start, const FloatSettings& settings, const scene::Run& run);

}  // namespace selvage::motion::floating
