// A simple polygon on the lattice, and what can be asked of one alone.
#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/lattice.h"

namespace selvage::geometry {

// The vertices of a simple polygon in counter-clockwise order, no vertex repeated, none in the middle of a straight
// edge.  Coordinates in lattice units.
using Polygon = std::vector<Vec>;

inline constexpr std::size_t kMaxVertices = 2000;  // of one shape

// Twice the signed area: positive for counter-clockwise.
[[nodiscard]] Wide doubled_area(std::span<const Vec> polygon);
[[nodiscard]] bool is_convex(std::span<const Vec> polygon);

enum class Location { kOutside, kBoundary, kInside };
// Where a point lies.  Exact.
[[nodiscard]] Location locate(Vec point, std::span<const Vec> polygon);

// What clean_polygon had to mend.
struct Repairs {
  std::size_t duplicate_vertices{};  // removed: equal to their predecessor
  std::size_t collinear_vertices{};  // removed: in the middle of a straight edge, or the tip of a zero-width spike
  bool reversed{};                   // was clockwise
  friend bool operator==(const Repairs&, const Repairs&) = default;
};
struct CleanPolygon {
  Polygon polygon;
  Repairs repairs;
};
// Makes any closed vertex list (first vertex repeated at the end or not, either sense) a Polygon.
// Errors: kTooManyVertices (before repair), kTooFewVertices, kZeroArea, kSelfIntersecting (names the two edges).
[[nodiscard]] Result<CleanPolygon> clean_polygon(std::span<const Vec> vertices);

}  // namespace selvage::geometry

// Vocabulary: named in selvage itself as well, so that every room may use it unqualified.
namespace selvage {
using geometry::Polygon;
}  // namespace selvage
