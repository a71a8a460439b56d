// The Minkowski sum of any two outlines, as the union of the star-shaped sums of their parts [Li94 3.4.3, Remark 4.2].
//
// A piece P at p and a piece Q at q overlap exactly when q - p lies in the interior of P (+) -Q [Li94 Theorem 3.1].
// The boundary is stored as edges with the sum's interior on their left, each on an exact lattice line; end points that
// are crossings of two lines are rounded to the lattice.  A sum may have holes.
// Units: lattice units.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/minkowski/convolution/star_sum.h"
#include "core/minkowski/rings/box_tree.h"
#include "core/outline/outline.h"

namespace selvage::minkowski {

class MinkowskiSum {
 public:
  // The union of the rings.  REQUIRES: there are some.
  explicit MinkowskiSum(std::vector<convolution::StarSum> rings);
  // The same; nothing when `stopped`, which is asked once for each ring unless it is empty.
  [[nodiscard]] static std::optional<MinkowskiSum> united(std::vector<convolution::StarSum> rings,
                                                          const std::function<bool()>& stopped);

  // The edges of the union's boundary.  Edges of the same ring are consecutive, and edges inside another ring are left
  // out.
  [[nodiscard]] std::span<const convolution::SumEdge> edges() const {
    return rings_.size() == 1 ? rings_[0].edges : visible_;
  }
  // The star-shaped sums whose union this is.
  [[nodiscard]] std::span<const convolution::StarSum> rings() const { return rings_; }
  [[nodiscard]] const Box& box() const { return box_; }
  // True when the point lies inside by more than the rounding of edges.
  [[nodiscard]] bool contains(RealVec point) const;
  [[nodiscard]] std::size_t bytes() const;

  // The box tree of edges().
  [[nodiscard]] const rings::BoxTree& tree() const { return tree_; }

 private:
  MinkowskiSum() = default;

  std::vector<convolution::StarSum> rings_;
  std::vector<Box> ring_boxes_;
  std::vector<convolution::SumEdge> visible_;  // used only when there are several rings
  rings::BoxTree tree_;
  Box box_;
};

// P (+) Q.
[[nodiscard]] MinkowskiSum minkowski_sum(std::span<const outline::StarPart> first,
                                         std::span<const outline::StarPart> second);
// P (+) -(Q under `relative`): two pieces overlap exactly when the position of Q relative to P lies in its interior.
[[nodiscard]] MinkowskiSum obstacle_sum(const outline::Outline& p, const outline::Outline& q, Symmetry relative);
// The same; nothing when `stopped`, which is asked for each pair of parts, within it as star_sum does, and for each
// ring.
[[nodiscard]] std::optional<MinkowskiSum> obstacle_sum(const outline::Outline& p, const outline::Outline& q,
                                                       Symmetry relative, const std::function<bool()>& stopped);

}  // namespace selvage::minkowski
