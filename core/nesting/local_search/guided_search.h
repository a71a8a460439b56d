// The guided local search for a layout without overlaps in a given length ([UYI+09], [GVW25]).
//
//     until nothing overlaps, or `strikes` times in a row nothing was gained:
//       until `patience` iterations in a row bring no progress:
//         move every piece that overlaps, in random order
//         raise the weights of the pairs that still overlap
//       go back to the best layout
//
// Units: model units.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/nesting/local_search/mover.h"

namespace selvage::nesting::local_search {

// How long a separation may take.
struct Persistence {
  std::size_t patience{}, strikes{};
};

class GuidedSearch {
 public:
  // `map_bytes`: memory for the sampled maps; fields take up to an eighth more.  REQUIRES: the set outlives
  // the search.  Once `stopped`, a move ends without the maps that it lacks, so that a layout may seem not to overlap
  // although it does.
  GuidedSearch(const layout::PieceSet& set, std::uint64_t seed, std::size_t map_bytes, const SearchTuning& tuning,
               std::function<bool()> stopped);

  // The layout of least loss that was found, and its loss: 0 when nothing overlaps by more than the tolerance.
  struct Outcome {
    layout::Layout layout;
    double loss{};
  };
  // `over` is asked before every move.
  [[nodiscard]] Outcome separate(layout::Layout layout, Persistence persistence, const std::function<bool()>& over);

  // Puts the pieces down, largest first, each where it ends leftmost; `kept` pieces stay where the layout has them.
  // The layout becomes as long as it needs to be.  Pieces that were not put down because of `over` lie beyond the ends
  // of the others.
  void build(layout::Layout& layout, const std::vector<bool>& kept, const std::function<bool()>& over);
  // Puts one piece where it ends leftmost without overlapping any of `others`, as far as the sampled maps can tell;
  // false when it fits nowhere within the layout's length.
  [[nodiscard]] bool insert(layout::Layout& layout, std::size_t piece, const std::vector<std::uint32_t>& others);
  // Moves one piece to where it overlaps least.
  void settle(layout::Layout& layout, std::size_t piece);
  // Of the pieces that may move and are not `spared`, the one with the largest loss; nothing when none has any.
  [[nodiscard]] std::optional<std::size_t> most_overlapping(const layout::Layout& layout,
                                                            std::optional<std::size_t> spared);
  // Changes the layout a little (perturbation.h).
  void perturb(layout::Layout& layout);

  [[nodiscard]] std::uint64_t moves() const { return moves_; }
  [[nodiscard]] layout::Dice& dice() { return dice_; }

 private:
  [[nodiscard]] std::vector<std::size_t> overlapping();

  const layout::PieceSet* set_;
  SearchTuning tuning_;
  layout::Dice dice_;
  depth::DepthMaps maps_;
  Losses losses_;
  Mover mover_;
  std::uint64_t moves_{};
};

}  // namespace selvage::nesting::local_search
