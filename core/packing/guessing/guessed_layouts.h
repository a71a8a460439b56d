// Layouts from guesses, beside an exact search: guesses are made at the pace of the search, and the layouts near each
// of them are searched in turn.  Where pieces have room to change places, this finds a layout long before branching
// does; it proves nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/packing/branching/subtree.h"
#include "core/packing/branching/tuning.h"
#include "core/packing/guessing/guesser.h"

namespace selvage::packing::guessing {

class GuessedLayouts {
 public:
  // The problem must outlive this.
  GuessedLayouts(const Problem& problem, const branching::SearchTuning& tuning, branching::PlaceLeaf place_leaf,
                 std::stop_token stop);

  // Makes some guesses that begin with the bodies near these positions.  True when there is a layout, which `next`
  // returns.
  [[nodiscard]] bool begin_at(const std::vector<RealVec>& positions);

  // Makes the guesses that are due after so much work, and adds the work of the searches near guesses.  Returns a
  // layout as soon as there is one.
  [[nodiscard]] std::optional<branching::Leaf> next(branching::Work& work);

 private:
  [[nodiscard]] std::optional<branching::Leaf> near(Guess guess, branching::Work& work) const;

  const Problem* problem_;
  branching::SearchTuning tuning_;
  branching::PlaceLeaf place_leaf_;
  std::stop_token stop_;
  double reach_{1};  // of a search near a guess; lattice units
  std::optional<Guesser> guesser_;
  std::uint64_t paid_{};                  // nodes of the search for which guesses were made
  std::optional<branching::Leaf> found_;  // since `next`, by begin_at
  branching::Work work_;                  // since `next`, of begin_at
};

}  // namespace selvage::packing::guessing
