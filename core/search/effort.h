// The work that a search may do, and the rule that ends a search that no longer gains.
//
// Gains of a local search grow roughly with the logarithm of the work: nine times as much further work will hardly gain
// more than the last nine tenths of the work have gained.  A search is therefore ended when the last nine tenths of its
// work brought no more than a tenth of all that it has gained, once it has done its least work.  A search that has
// gained nothing ends after a third of that.
// Units: work is the number of pieces, summed over all programs solved; lengths are in lattice units.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/geometry/lattice.h"

namespace selvage::search {

inline constexpr double kFurtherWork = 10;   // a search goes on while this many times the work may bring
inline constexpr double kWorthIt = 0.1;      // this part more of the gain
inline constexpr std::uint64_t kInVain = 3;  // a search without any gain ends after the least work divided by this

class Effort {
 public:
  // `start` is the length that gains are measured from; the rule holds from the least work on.
  Effort(std::uint64_t least, std::uint64_t most, Coord start) : least_{least}, most_{most}, start_{start} {}

  // Adds work; `length` is the best length after it.
  void spend(std::uint64_t work, Coord length);
  [[nodiscard]] std::uint64_t spent() const { return spent_; }
  [[nodiscard]] bool enough() const;

 private:
  // What had been gained when no more than this work had been done.
  [[nodiscard]] Coord gain_at(double work) const;

  std::uint64_t least_, most_;
  Coord start_;
  std::uint64_t spent_{};
  std::vector<std::pair<std::uint64_t, Coord>> gains_;  // work, and the gain after it; both ascending
};

}  // namespace selvage::search
