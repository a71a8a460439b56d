// The tuning constants of the search for cuttings.  All of them count work; none is a time.
#pragma once

#include <cstddef>
#include <cstdint>

namespace selvage::planning::cheapest {

// Up to this number of ratios are listed; beyond, candidates are generated.
inline constexpr std::size_t kMostListed = 10'000;

struct SearchTuning {
  int annealing_steps{60'000};         // of each annealing, at most
  int steps_of_candidate{130};         // and for each candidate
  int annealings{3};                   // with as many markers as sizes, one more, ...
  std::uint64_t set_work{40'000'000};  // of listing the sets of few markers (program/few_markers.h)
  std::size_t near_candidates{60};     // of an integer program around the best cutting so far
  std::size_t last_candidates{500};    // of the program that closes the gap
  int nodes{60};                       // of each program but the last
  int neighbourhoods{2};               // most programs around the best cutting
  int last_nodes{200};
  friend bool operator==(const SearchTuning&, const SearchTuning&) = default;
};

}  // namespace selvage::planning::cheapest
