// The tuning constants of filling; docs/measurements/searches/nesting.md has what it gains.
#pragma once

#include <cstddef>

namespace selvage::nesting::filling {

struct FillTuning {
  std::size_t patience{15};   // iterations without progress that end the separation of a trial
  double added{0.5};          // part of the trials that add a piece, when there may be room for one,
  double swapped{0.5};        // and part of the others that exchange two; the rest wedge one in among others
  int separation_rounds{12};  // when repair cannot remove what the search has left
  friend bool operator==(const FillTuning&, const FillTuning&) = default;
};

}  // namespace selvage::nesting::filling
