// Containment problems whose answers are known by other means.
//
// An answer that contradicts what is known is a fault.  So is a marker that the judge (tests/judge) finds invalid, and
// a question that is left undecided.
#pragma once

#include <cstdint>
#include <string>

#include "core/minkowski/cache.h"
#include "core/packing/contain.h"
#include "tests/support/random.h"

namespace selvage::test {

struct Judged {
  packing::Verdict verdict{};
  std::uint64_t nodes{};
  std::string fault{};  // empty when there is none
};

// Up to seven pieces of a random valid marker have to be placed again within its length, among all others.  They fit,
// because they lay there before.
[[nodiscard]] Judged judged_cut_out(Random& random, SumCache& sums);

// Three to six random polyominoes have to be placed into a box of about their area.  They fit if a search over unit
// squares, which tries all positions, places them.
[[nodiscard]] Judged judged_polyominoes(Random& random, SumCache& sums);

}  // namespace selvage::test
