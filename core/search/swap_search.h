// The swaps of refinement: a local search in which every trial swaps two pieces or turns one (swap.h), and keeps the
// marker if it does not become longer.
//
// Most trials begin with a piece on the critical path (core/motion/compaction/critical_path.h): no other swap can
// shorten the marker.  In a tilted marker, a trial that comes close is also tilted, as long as its rounds gain enough.
// Threads make several trials in parallel, all on the same marker; only those count that a sequential run would have
// made: up to the first one that is kept.  So the answer does not depend on the number of threads.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "core/marker/marker.h"
#include "core/scene/run.h"
#include "core/search/effort.h"
#include "core/search/found.h"
#include "core/search/swap.h"
#include "core/search/tuning.h"

namespace selvage::search {

class SwapSearch {
 public:
  // Called after each trial that counts, with the number of programs it solved; true: the trial's marker was kept.
  using Report = std::function<void(int programs, bool kept)>;

  // The referenced values must outlive this.
  SwapSearch(std::uint32_t seed, const RefineTuning& tuning, const scene::Run& run, Report report)
      : tuning_{tuning}, run_{run}, report_{std::move(report)}, random_{seed} {}

  // Trials in `found` until the effort is enough, or has reached `until`, or there is nothing to swap.  `tilted`:
  // trials that come close are tilted.
  void search(Found& found, bool tilted, std::uint64_t until, Effort& effort);
  // True when RefineTuning::idle_trials in a row have found no swap, or only too deep ones.
  [[nodiscard]] bool exhausted() const { return idle_ >= tuning_.idle_trials; }

 private:
  struct Trial;
  [[nodiscard]] std::vector<Trial> drawn(std::size_t count, const Marker& marker) const;
  void make(std::vector<Trial>& trials, std::size_t k, Coord best, bool tilted) const;
  void tilt(Trial& trial, Coord best, const scene::Run& run) const;
  void find_critical(const Marker& marker);

  const RefineTuning& tuning_;
  const scene::Run& run_;
  Report report_;
  std::mt19937 random_;
  std::vector<PieceId> critical_;  // the pieces on the critical path
  std::uint64_t idle_{};           // trials in a row that solved no program
};

}  // namespace selvage::search
