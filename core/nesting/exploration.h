// One search for the shortest marker, from one start [GVW25].
//
//     put the pieces down one after another; separate and compact them
//     until that fails: shorten the strip, separate, compact
//     then, by turns or only one of the two:
//                     walk: perturb a marker that is hardly longer than the best one, separate, compact
//                     attempt: shorten the best one, perturb a layout that could not be separated, separate, compact
//     compress: shorten the best layout by a little at a random place, separate, compact
//
// Every layout that the guided local search has separated is compacted by linear programs and proved in integers before
// it counts; the strip is then shortened from the compacted length.  A walk is an iterated local search that accepts
// what is hardly longer than the best ("record-to-record travel") [LMS03, Due93].  On some instances it soon finds
// nothing shorter, while attempts still do [GVW25]; on others it finds more in the same time.  A search may be
// interrupted and continued later (race.h).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/marker/marker.h"
#include "core/nesting/budget.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/local_search/guided_search.h"
#include "core/nesting/tuning.h"
#include "core/scene/run.h"

namespace selvage::nesting {

// The length of the best marker of a search, and the moves after which it was found.
struct Improvement {
  std::uint64_t moves{};
  Coord length{};  // lattice units
  friend bool operator==(const Improvement&, const Improvement&) = default;
};

// Where the cloth ends, and how long a search continues that has not fitted all pieces before the end.
struct ClothEnd {
  Coord last{};       // the largest x that a piece may reach; lattice units
  double patience{};  // part of the budget
};

// What a search does when it can no longer shorten its marker by the least step.
enum class OnStall { kTakeTurns, kWalk, kAttempt };

class Exploration {
 public:
  using OnBetter = std::function<void(const Improvement&, const Marker&)>;
  // The best marker of all searches, when it is shorter than this.
  using Shorter = std::function<std::optional<Marker>(Coord)>;

  // `best` is valid on an endless strip, places all pieces, and is what the search has to beat; `search` may be shared
  // with other explorations, one after another; `end`: nothing when the cloth does not end; `shorter`: empty when there
  // is no other search, or none that it may learn from.
  // REQUIRES: the set, the search and the run outlive it.
  Exploration(const layout::PieceSet& set, Marker best, local_search::GuidedSearch& search, const NestTuning& tuning,
              OnStall on_stall, Budget budget, std::optional<ClothEnd> end, const scene::Run& run, OnBetter on_better,
              Shorter shorter = {});

  // Builds the first layout, in which the `kept` pieces lie where `start` has them.
  void begin(layout::Layout start, const std::vector<bool>& kept);
  // Sets what it does once it has stalled.  A kind of turn that the tuning switches off is replaced by the other.
  void when_stalled(OnStall on_stall);
  // Searches until it has made this many more moves, the budget is used up, or nothing shorter is possible.
  void advance(std::uint64_t moves);

  [[nodiscard]] const Marker& best() const { return best_; }
  [[nodiscard]] Coord length() const { return length_; }
  [[nodiscard]] int programs() const { return programs_; }
  [[nodiscard]] bool converged() const { return converged_; }

 private:
  // Calls work(), which ends after this many moves of this exploration.
  template <class Work>
  void limited(std::uint64_t moves, const Work& work);
  void search();
  void explore();
  void take_a_turn();
  void take_over();
  void walk(std::uint64_t end);  // own moves at which the turn ends
  void attempt(std::uint64_t end);
  void compress();
  void shorten_boldly();
  void shorten(double part, double split);
  [[nodiscard]] bool separate(local_search::Persistence persistence);
  // Makes a valid marker of a layout that hardly overlaps, which becomes the best when it is shorter.
  [[nodiscard]] std::optional<Marker> proved(const layout::Layout& layout);
  void become_best(Marker marker);
  [[nodiscard]] std::uint64_t own_moves() const { return before_ + (search_->moves() - taken_up_at_); }
  [[nodiscard]] bool exploring() const { return budget_.exploring(own_moves()); }
  [[nodiscard]] bool over() const;
  [[nodiscard]] double best_length() const { return static_cast<double>(length_) / set_->lattice_units; }

  const layout::PieceSet* set_;
  NestTuning tuning_;
  OnStall on_stall_{};
  Budget budget_;
  std::optional<ClothEnd> end_;
  const scene::Run* run_;
  OnBetter on_better_;
  Shorter shorter_;
  local_search::GuidedSearch* search_;
  std::uint64_t taken_up_at_{};  // moves of the search when this exploration began its present part
  std::uint64_t before_{};       // moves of this exploration before that
  std::uint64_t until_{};        // moves of the search at which the present part ends
  Marker best_;
  Coord length_;
  double required_length_;  // to go on, the best marker must be shorter than this; lattice units
  double least_length_;     // no marker is shorter; model units
  double step_;
  bool stalled_{};  // an attempt with the least step has failed
  bool walking_{};  // what the next turn does once it has stalled
  bool converged_{};
  layout::Layout layout_;  // the one that is worked on
  int programs_{};
};

}  // namespace selvage::nesting
