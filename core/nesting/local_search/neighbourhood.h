// The pieces around a position that a piece may take, for the many evaluations of its loss that a descent asks for.
//
// Only pieces that can be touched within the reach of the descent are kept, and of their sums only the edges that can
// be the nearest one, or be crossed, within it.  Losses within the reach are therefore exact and cheap. Units: model
// units.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/nesting/depth/depth_maps.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/layout/placed_boxes.h"
#include "core/nesting/local_search/losses.h"

namespace selvage::nesting::local_search {

class Neighbourhood {
 public:
  // REQUIRES: all of them outlive the neighbourhood.
  Neighbourhood(const layout::PieceSet& set, depth::DepthMaps& maps, const Losses& losses)
      : set_{&set}, maps_{&maps}, losses_{&losses}, boxes_{set} {}

  // Takes in where the pieces lie.
  void take(const layout::Layout& layout) { boxes_.take(layout); }
  // Finds the pieces that the piece can touch at positions within `reach` of the place, on either axis.
  // REQUIRES: the layout has been taken in, and no other piece has moved since.
  void gather(const layout::Layout& layout, std::size_t piece, const layout::Place& place, double reach);
  // Puts the pieces in order of their losses at the place, going by the sampled maps: the largest first.
  void order_roughly(const layout::Place& place);
  // Keeps only the edges that matter within `reach` of the place, and only the pieces that have such edges, in order of
  // their losses there.
  void keep_edges(const layout::Place& place, double reach);

  // The loss at a position, guided by the weights; may end early with a value of at least `bound`.
  [[nodiscard]] double loss(double x, double y, double bound) const;
  // The same from the sampled maps.
  [[nodiscard]] double rough_loss(double x, double y, double bound) const;

 private:
  struct Near {
    depth::MapView view;
    double x{}, y{};  // position of the other piece
    float weight{};
    float there{};             // its loss at the place by which the pieces are ordered
    std::size_t kept{};        // index of its kept edges
    float from_x{}, from_y{};  // in the map's frame: where they were kept,
    bool from_inside{};        // and whether that was inside
  };
  // A loss that exceeds its bound is then known after few pieces.
  void put_large_losses_first();
  [[nodiscard]] float depth(const Near& near, float x, float y) const;

  const layout::PieceSet* set_;
  depth::DepthMaps* maps_;
  const Losses* losses_;
  layout::PlacedBoxes boxes_;
  std::vector<std::uint32_t> candidates_;  // for near_, by their boxes
  std::vector<Near> near_;
  std::vector<depth::Boundary> kept_;  // reused from one descent to the next
  double kept_reach_{};                // 0: no edges are kept
  std::vector<float> squared_;
};

}  // namespace selvage::nesting::local_search
