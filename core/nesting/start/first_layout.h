// The valid marker of all pieces that a nesting search starts from, and that it has to beat.
//
// Unless pieces have rules, this is a layout on shelves, which needs no search.  Shelves do not always keep shades, or
// bands that end (shelves.h); where they do not, a guided local search looks for a layout that does, on ever longer
// strips.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "core/nesting/layout/piece_set.h"
#include "core/nesting/local_search/tuning.h"
#include "core/scene/run.h"

namespace selvage::nesting::start {

struct FirstLayoutSettings {
  std::uint64_t seed{};
  std::size_t map_bytes{};    // of the sampled maps of the search
  std::size_t most_pieces{};  // there is no search for larger sets
  int separation_rounds{};    // when repair cannot remove what the search has left
  local_search::SearchTuning search{};
  std::function<bool()> out_of_time{};  // whether the caller's time is used up, or it has stopped the run
};

// `kept` pieces stay where they are when shelves will do; otherwise only the fixed ones do.
// REQUIRES: those of on_shelves; kept pieces are valid together.
// Errors: kBeyondLattice as on_shelves; kOutOfRange when no layout was found in which all pieces keep their rules, with
// the name of a piece that found no room; kStoppedEarly when stopped before, or late.
[[nodiscard]] Result<Marker> first_layout(const Marker& start, const layout::PieceSet& set,
                                          const std::vector<bool>& kept, const FirstLayoutSettings& settings,
                                          const scene::Run& run);

}  // namespace selvage::nesting::start
