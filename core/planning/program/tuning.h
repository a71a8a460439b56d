// The tuning constants of the search for cuttings.  All of them count work; none is a time.
#pragma once

#include <cstddef>

namespace selvage::planning::program {

// Up to this number of ratios are listed; beyond, candidates are generated.
inline constexpr std::size_t kMostListed = 10'000;
inline constexpr std::size_t kPricingNodes = 200'000;  // of one search for the ratio of the least reduced cost
inline constexpr int kGenerations = 200;               // rounds of column generation
inline constexpr double kPricingTolerance = 1e-7;  // of the bound: reduced costs above minus this end the generation

struct SearchTuning {
  std::size_t first_candidates{40};  // of the first integer program: those that add least to the bound
  std::size_t near_candidates{60};   // of a program around the best cutting so far
  std::size_t last_candidates{500};  // of the program that closes the gap
  int nodes{150};                    // of each program but the last
  int neighbourhoods{6};             // most programs around the best cutting
  int last_nodes{600};
  friend bool operator==(const SearchTuning&, const SearchTuning&) = default;
};

}  // namespace selvage::planning::program
