// The kernel of a part of a polygon that grows triangle by triangle: decides quickly, in most cases, whether the part
// stays star-shaped.
//
// A part's kernel is the intersection of the half-planes to the left of its edges.  Edges of the polygon stay edges of
// the part for good; cuts of the triangulation go when the part grows across them.  So the cell of the polygon's edges
// only shrinks, and one more triangle costs two clips of a small cell instead of one clip per edge of the part.
//
// The cells are computed in doubles, with every half-plane moved outwards by kSlack lattice units, which exceeds their
// rounding.  An empty cell therefore proves that there is no kernel point; a point deep inside it is one; and when
// neither holds the caller has to compute the kernel itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/outline/decomposition/convex_cell.h"
#include "core/outline/decomposition/triangulation.h"

namespace selvage::outline::decomposition {

enum class KernelVerdict {
  kDeep,     // the grown part has a kernel point well inside its kernel
  kEmpty,    // the grown part has no kernel
  kUnclear,  // its kernel is too small to tell
};

class GrowingKernel {
 public:
  // REQUIRES: the polygon outlives this.
  explicit GrowingKernel(const Polygon& polygon);

  // Begins a part: one triangle of the polygon's triangulation.
  void start(const Triangle& seed);
  // What becomes of the kernel when the part takes a triangle that shares exactly one cut with it.
  [[nodiscard]] KernelVerdict try_triangle(const Triangle& triangle);
  // Takes the triangle that was tried last.
  void take();

 private:
  using Cell = ConvexCell;
  using Edge = std::pair<std::uint32_t, std::uint32_t>;  // vertices of the polygon, in counter-clockwise order

  [[nodiscard]] bool is_cut(Edge edge) const;
  void clip(Cell& cell, Edge edge);

  const Polygon& polygon_;
  Box box_;
  Vec centre_;
  Cell fixed_;              // of the polygon's edges alone
  Cell kernel_;             // inside the part's kernel, often all of it
  std::vector<Edge> cuts_;  // of the part's boundary
  struct {
    Cell fixed, kernel;
    std::size_t crossed{};         // the place in cuts_ of the cut that the triangle is behind
    std::array<Edge, 2> beyond{};  // its other edges
  } tried_;
  Cell scratch_;
};

}  // namespace selvage::outline::decomposition
