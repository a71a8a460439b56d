// The tuning constants of placing.  They affect the time only: the position found is the nearest free one whatever they
// are, except for `proofs` in corners so narrow that they hold hardly any lattice point, and `repeats`.
#pragma once

#include <cstddef>

namespace selvage::motion::placing {

struct PlaceTuning {
  double first_reach{1.0 / 32};  // part of the width: how far the first search looks
  double farther{4};             // factor on that for every further search
  std::size_t few_lines{6};      // a cell with at most this many borders is searched, one with more is divided
  double small{64};              // lattice units: a cell of at most this size is searched, too
  double clear{3};               // lattice units: points deeper inside an obstacle are not worth a proof
  int proofs{12};                // lattice positions that are proved about one point
  std::size_t repeats{160};      // of the cloth's pattern, the nearest ones, that are tried for a piece matched to it
};

}  // namespace selvage::motion::placing
