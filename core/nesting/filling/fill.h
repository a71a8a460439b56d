// Filling: chooses which of the pieces lie on a strip that ends, so that together they are worth as much as the search
// can achieve.
//
//     put down as many of the pieces as fit, the largest first; again, those that are worth most for their area
//     until the budget is used up, or no trial could raise the value:
//       put a piece that is left over on the strip, perhaps in place of one that is worth less
//       separate [GVW25]; while that fails and the pieces are worth more, take the one off that overlaps most
//       compact, prove; keep what is worth more
//
// While a piece does not lie on the strip, it is parked far beyond its end, apart from all others, so that the local
// search sees it as one that overlaps nothing.
//
// Laws.  (1) The pieces that lie are valid, proved in integers.  (2) They are never worth less than those that lay at
// first.  (3) Fixed pieces stay where they are.  (4) The same input and settings give the same answer.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/marker/marker.h"
#include "core/nesting/filling/tuning.h"
#include "core/nesting/layout/piece_set.h"
#include "core/nesting/local_search/tuning.h"
#include "core/scene/run.h"

namespace selvage::nesting::filling {

struct FillSettings {
  std::vector<double> values;  // by piece of the set; at least 0
  std::uint64_t seed{};
  std::size_t map_bytes{};       // of the sampled maps
  std::optional<double> room{};  // what pieces can cover, in square lattice units; none: all of the strip
  std::function<bool(std::uint64_t moves)> over;
  local_search::SearchTuning search{};
  FillTuning tuning{};
};

// `marker` has all pieces as placed ones, of which some lie (lying.h).
struct Filling {
  Marker marker;
  std::vector<bool> lies{};
  double value{};  // of the pieces that lie
  std::uint64_t moves{};
  int programs{};
};

// What the pieces that lie are worth together.
[[nodiscard]] double value_of(const std::vector<bool>& lies, const std::vector<double>& values);

// REQUIRES: `start.marker` has all pieces of the set as placed ones, in the set's order, and its strip ends; the pieces
// that lie are valid on it, and the fixed ones lie.
[[nodiscard]] Filling fill(Filling start, const layout::PieceSet& set, const FillSettings& settings,
                           const scene::Run& run);

}  // namespace selvage::nesting::filling
