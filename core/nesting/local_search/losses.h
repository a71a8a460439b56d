// The objective of the search: the sum of all pairs' losses, and the weights that guide it out of local minima (guided
// local search, [UYI+09], [GVW25]).
//
// A pair's loss is 0 when the two do not overlap, and otherwise importance * (charge + depth), where large pieces have
// a larger importance.  A move minimises the sum of weight * loss; weights of pairs that keep overlapping grow.
#pragma once

#include <cstddef>
#include <vector>

#include "core/nesting/depth/depth_maps.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/local_search/tuning.h"

namespace selvage::nesting::local_search {

class Losses {
 public:
  Losses(const layout::PieceSet& set, depth::DepthMaps& maps, const SearchTuning& tuning);

  // Computes all losses and sets all weights to 1.
  void reset(const layout::Layout& layout);
  // Computes all losses.
  void measure(const layout::Layout& layout);
  // Computes those of one piece, after it has moved.
  void measure(const layout::Layout& layout, std::size_t piece);
  // Raises the weights of pairs that overlap and lowers those of the others.
  void reweigh();

  [[nodiscard]] double total() const;
  [[nodiscard]] double of(std::size_t piece) const { return of_piece_[piece]; }
  [[nodiscard]] float weight(std::size_t first, std::size_t second) const { return weights_[first * size_ + second]; }
  [[nodiscard]] float importance(std::size_t first, std::size_t second) const {
    return importance_[set_->kind_of[first]] * importance_[set_->kind_of[second]];
  }
  // What a depth costs a move, before it is multiplied by the importance and the weight.  Moves aim at half of the
  // tolerance, so that rounding a position does not make a pair count as overlapping that the move has separated.
  [[nodiscard]] float aimed(float depth) const { return depth > tolerance_ / 2 ? charge_ + depth : 0; }

 private:
  [[nodiscard]] float charged(float depth) const { return depth > tolerance_ ? charge_ + depth : 0; }
  [[nodiscard]] float pair_loss(const layout::Layout& layout, std::size_t first, std::size_t second);

  const layout::PieceSet* set_;
  depth::DepthMaps* maps_;
  std::size_t size_;
  float charge_, tolerance_;
  double growth_, extra_growth_, decay_;
  std::vector<float> importance_;        // by kind: a pair's is the product of both
  std::vector<float> losses_, weights_;  // by pair; symmetric
  std::vector<std::size_t> raised_;      // the pairs whose weight is not 1, each once: a few of many
  std::vector<double> of_piece_;         // the sum of a piece's pairs
};

}  // namespace selvage::nesting::local_search
