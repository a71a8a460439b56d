// A simple polygon on the lattice: its area, convexity, point location, and repair of raw vertex lists.
#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/lattice.h"

namespace selvage::geometry {

// The vertices of a simple polygon in counter-clockwise order, without repeated vertices and without vertices in the
// middle of a straight edge.  Units: lattice units.
using Polygon = std::vector<Vec>;

inline constexpr std::size_t kMaxVertices = 2000;  // of one shape

// Twice the signed area; positive for a counter-clockwise polygon.
[[nodiscard]] Wide doubled_area(std::span<const Vec> polygon);
// The area, rounded to a double; of a counter-clockwise polygon.
[[nodiscard]] double area_of(std::span<const Vec> polygon);
[[nodiscard]] bool is_convex(std::span<const Vec> polygon);
[[nodiscard]] Polygon moved(Polygon polygon, Vec by);

enum class Location { kOutside, kBoundary, kInside };
// Whether the point lies inside, outside or on the boundary.  Exact.
[[nodiscard]] Location locate(Vec point, std::span<const Vec> polygon);

// The repairs that clean_polygon made.
struct Repairs {
  std::size_t duplicate_vertices{};  // removed because they equal their predecessor
  std::size_t collinear_vertices{};  // removed because they lie in the middle of a straight edge or at the tip of a
                                     // zero-width spike
  bool reversed{};                   // the vertices were clockwise and have been reversed
  friend bool operator==(const Repairs&, const Repairs&) = default;
};
struct CleanPolygon {
  Polygon polygon;
  Repairs repairs;
};
// Makes a Polygon of any closed vertex list, in either sense, with or without the first vertex repeated at the end.
// Errors: kTooManyVertices (checked before repair), kTooFewVertices, kZeroArea, kSelfIntersecting (the message names
// the two edges).
[[nodiscard]] Result<CleanPolygon> clean_polygon(std::span<const Vec> vertices);

// The polygon moved by `by`, its vertices listed from the smallest on: the same wherever the given list starts.
[[nodiscard]] Polygon normal_form(Polygon polygon, Vec by = {});

}  // namespace selvage::geometry

// Basic types: also available in namespace selvage, so that every folder can use them unqualified.
namespace selvage {
using geometry::Polygon;
}  // namespace selvage
