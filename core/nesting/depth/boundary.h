// The boundary of a Minkowski sum as a list of edges, laid out for the evaluation of many edges at once.
// Units: model units.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/minkowski/convolution/star_sum.h"

namespace selvage::nesting::depth {

// One array per component; padded to a multiple of kLanes by edges that are far from everything.
struct Boundary {
  std::vector<float> ax, ay;          // where an edge starts
  std::vector<float> dx, dy;          // from its start to its end
  std::vector<float> inverse_square;  // 1 / its squared length; 0 for an edge without length
  std::vector<float> end_y, run;      // y of its end; dx / dy, 0 for a horizontal edge
  std::size_t edges{};                // without the padding

  void add(float from_x, float from_y, float to_x, float to_y);
  // Pads the arrays.  REQUIRES: nothing is added afterwards.
  void finish();
  // Becomes those edges of another boundary whose squared distances are at most `limit`, padded.
  void assign_near(const Boundary& whole, const std::vector<float>& squared, float limit);
  [[nodiscard]] std::size_t bytes() const { return ax.capacity() * 7 * sizeof(float); }
};
[[nodiscard]] Boundary boundary_of(std::span<const minkowski::convolution::SumEdge> edges, double lattice_units);

// The distance of a point to the boundary, squared, and whether the point lies inside.
struct Nearness {
  float squared_distance{};
  bool inside{};
};
[[nodiscard]] Nearness nearness(const Boundary& boundary, float x, float y);
// The same, and the squared distance to every edge in `squared`, which has room for the padding.
[[nodiscard]] Nearness nearness_of_each(const Boundary& boundary, float x, float y, std::vector<float>& squared);
// The squared distances of a row of points alone: of (xs[k], y), for each of the lanes.
void squared_distances(const Boundary& boundary, const float* xs, float y, float* squared);
// The same as nearness, for a boundary of which only the edges near the segment from (from_x, from_y) to the point are
// left: a point is inside if its parity of crossings with the segment differs from what `from_inside` says.
[[nodiscard]] Nearness nearness_along(const Boundary& boundary, float from_x, float from_y, bool from_inside, float x,
                                      float y);

}  // namespace selvage::nesting::depth
