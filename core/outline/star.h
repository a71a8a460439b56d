// Star-shaped polygons: kernel points, and the decomposition of any simple polygon into star-shaped parts [Li94 3.4.3].
// A polygon is star-shaped when every point of it is visible from some point; such points form its kernel.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"
#include "core/geometry/real_plane.h"

namespace selvage::outline {

// A point well inside the kernel: every edge's line passes it on the left at a distance of at least kKernelDepth.
// Nothing when there is no such point, that is, when the polygon is not star-shaped or only just so.
inline constexpr double kKernelDepth = 1.0 / 64;  // lattice units
[[nodiscard]] std::optional<RealVec> kernel_point(const Polygon& polygon);

// The polygon's edge vectors into and out of one of its vertices.
struct Turn {
  Vec in, out;
};
// One star-shaped part of a polygon.
struct StarPart {
  Polygon vertices;
  RealVec kernel;
  std::vector<std::uint32_t> origin;  // each vertex's index in the whole polygon
  std::vector<Turn> turns{};  // the whole polygon's turn at each vertex; empty when the part is the whole polygon
};
// The image under a symmetry; `origin` and `turns` follow the order of its vertices.
[[nodiscard]] StarPart transformed(const StarPart& part, Symmetry symmetry);

// Parts with disjoint interiors whose union is the polygon.  A star-shaped polygon has one part.  Otherwise the
// triangles of a triangulation are merged greedily while the union has a kernel point.  A thin triangle without a
// kernel point forms a part of its own.
[[nodiscard]] std::vector<StarPart> star_parts(const Polygon& polygon);

}  // namespace selvage::outline
