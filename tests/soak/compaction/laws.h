// Laws of a compaction of one marker, checked against other motions and by independent code.
#pragma once

#include <string>

#include "core/marker/marker.h"
#include "core/minkowski/cache.h"
#include "tests/judge/judge.h"

namespace selvage::test {

inline constexpr double kSignificant = 1e-4;  // fraction of the length: 0.01 %

struct CompactionVerdict {
  std::string fault;       // the violated law; empty when there is none
  double beyond_sweeps{};  // by how much compaction ends longer than sweeps of single pieces do; part of the length
  double second_gain{};    // what compacting the answer once more gains; part of the length
  double after_bump{};     // what it gains once a piece that holds the length has been bumped to the left
};

// Laws.  (1) The answer of accuracy `standard` is valid.  (2) It is no longer than that of sweeps of single-piece moves
// by more than kSignificant.  (3) The contacts that hold its length are contacts: both pieces are there.
[[nodiscard]] CompactionVerdict judged_compaction(const Marker& start, SumCache& sums);

}  // namespace selvage::test
