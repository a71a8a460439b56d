// Short proofs that pieces do not fit, beside an exact search: searches for their cores (coarsening.h), the smallest
// cores first, at the pace of the search.  Where there is no layout of the cores there is none of the pieces; where
// there is one, larger cores are searched.  It finds no layout of the pieces, but those of the cores are good places to
// begin guesses of one (guessing/guessed_layouts.h).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/marker/marker.h"
#include "core/packing/bodies/bodies.h"
#include "core/packing/branching/search.h"
#include "core/scene/run.h"

namespace selvage::packing::cores {

// Called with the positions of a layout of the cores, by body: the bodies of the cores are, in this order, those of
// their pieces.  True when the search for cores is not to go on.
using OnCores = std::function<bool(const std::vector<RealVec>& positions)>;

class Refutation {
 public:
  // The marker and the freedom must outlive this.
  Refutation(const Marker& marker, const bodies::Freedom& freedom, const branching::SearchTuning& tuning,
             const scene::Run& run, OnCores on_cores);
  Refutation(const Refutation&) = delete;
  Refutation& operator=(const Refutation&) = delete;

  // Searches as is due after so much work of the search for the pieces, and sets `own` to its own work so far.  True as
  // soon as it is proved that there is no layout.
  [[nodiscard]] bool next(const branching::Work& searched, branching::Work& own);

 private:
  // The search for the cores of one share.
  struct Level {
    bodies::Bodies bodies;
    std::vector<RealVec> found;  // the positions of a layout
    branching::Search search;
    Level(const Marker& marker, const Refutation& refutation);
  };
  // Begins the search for the smallest cores that are left.  False when there are none.
  bool begin();

  const Marker& marker_;
  const bodies::Freedom& freedom_;
  branching::SearchTuning tuning_;
  scene::Run run_;
  OnCores on_cores_;
  std::size_t next_share_{};
  std::optional<Marker> cores_;  // of the last level that was begun
  std::optional<Level> level_;
  branching::Work finished_;  // of the levels before it
};

}  // namespace selvage::packing::cores
