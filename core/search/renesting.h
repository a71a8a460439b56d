// Nesting within refinement: the guided local search of core/nesting/nest.h, from where the pieces lie.
#pragma once

#include <cstdint>
#include <functional>

#include "core/scene/run.h"
#include "core/search/found.h"

namespace selvage::search {

struct RenestingSettings {
  std::uint64_t moves{};
  std::uint64_t moves_in_vain{};  // that end it when they have gained
  double least_gain{};            // no more than this part of the length
  std::uint64_t seed{};
  std::function<double()> elapsed{};  // as of nesting; empty when only moves are limited
};

struct Renesting {
  std::uint64_t moves{};
  int programs{};  // linear programs solved
};

// Nests the placed pieces anew and keeps in `found` what is shorter; unplaced pieces stay unplaced.  A marker that
// nesting refuses stays as it is.
// REQUIRES: the marker is valid.
Renesting renest(Found& found, const RenestingSettings& settings, const scene::Run& run);

}  // namespace selvage::search
