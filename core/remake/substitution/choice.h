// The choice of the stored markers to take over: those whose pieces differ least from the order's, and whose cloth was
// used best.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/base/executor.h"
#include "core/matching/pairing.h"
#include "core/remake/substitution/arrangement.h"
#include "core/remake/substitution/tuning.h"

namespace selvage::remake::substitution {

struct Candidate {
  Arrangement arrangement;
  matching::Pairing pairing;
  double difference{};  // of the pairing, as a part of the order's area
  double used{};        // the utilisation of the arrangement, 0..1
  double predicted{};   // the utilisation that is expected, 0..1
};

// The arrangements near enough to be tried, best prediction first: single markers and, where two together are as large
// as the order, concatenations.  `concatenate` false: single markers only.  Names and sizes settle which piece takes
// the place of which stored one; the prediction depends on the shapes of these pairs alone.
// Arrangements with which more than `tuning.most_compared` comparisons of pieces would be needed are left out.  When
// cancelled, there are none: a caller that may be cancelled looks at the token afterwards.
// Units: see Candidate.  Deterministic; another stored marker only adds candidates.
[[nodiscard]] std::vector<Candidate> candidates_for(const matching::LabelledMarker& order,
                                                    std::span<const matching::LabelledMarker> stored, bool concatenate,
                                                    const RemakeTuning& tuning, const Executor& executor,
                                                    const std::stop_token& stop = {});

}  // namespace selvage::remake::substitution
