// Star-shaped polygons: kernels, and the decomposition of any simple polygon into star-shaped parts [Li94 3.4.3].
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"
#include "core/geometry/real_vec.h"

namespace selvage::outline {

// A point well inside the kernel: every edge's line passes it on the left at a distance of at least kKernelDepth.
// Nothing when the polygon is not star-shaped, or only just.
inline constexpr double kKernelDepth = 1.0 / 64;  // lattice units
[[nodiscard]] std::optional<RealVec> kernel_point(const Polygon& polygon);

// A polygon's edges into and out of one of its vertices.
struct Turn {
  Vec in, out;
};
// One star-shaped part of a polygon.
struct StarPart {
  Polygon vertices;
  RealVec kernel;
  std::vector<std::uint32_t> origin;  // each vertex's index in the whole polygon
  std::vector<Turn> turns{};          // the whole polygon's at each vertex; empty when the part is the whole
};
// The image under a symmetry; `origin` and `turns` go with its vertices.
[[nodiscard]] StarPart transformed(const StarPart& part, Symmetry symmetry);

// Parts whose union is the polygon and whose interiors are disjoint: one for a star-shaped polygon, else triangles of a
// triangulation grown greedily while the kernel test holds.  A sliver without a deep kernel stays a triangle on its
// own.
[[nodiscard]] std::vector<StarPart> star_parts(const Polygon& polygon);

}  // namespace selvage::outline
