// Exact results computed by CGAL, the independent reference that the project's results are compared with.  Only tests
// use CGAL's set operations.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/minkowski/sum.h"
#include "core/outline/star.h"

namespace selvage::test {

// Whether a closed vertex list is a simple polygon.
[[nodiscard]] bool is_simple_exactly(std::span<const Vec> vertices);
// Whether a point lies inside, outside or on the boundary.  The point's doubles are taken as exact numbers.
[[nodiscard]] geometry::Location locate_exactly(RealVec point, const Polygon& polygon);
// True when the intersection of the two polygons has positive area.
[[nodiscard]] bool interiors_meet(const Polygon& p, const Polygon& q);
// True when `outer` contains `inner`: the part of `inner` outside `outer` has no area.
[[nodiscard]] bool holds(const Polygon& outer, const Polygon& inner);
// The sign of (distance between the closed polygons) - `distance`: -1 nearer, 0 exactly at it, 1 farther.
// REQUIRES: the interiors do not intersect.
[[nodiscard]] int compare_distance(const Polygon& p, const Polygon& q, Coord distance);

// The areas of the connected regions of the box that no polygon covers, largest first.
[[nodiscard]] std::vector<double> areas_left_over(const Box& box, std::span<const Polygon> polygons);

using Segment = std::pair<RealVec, RealVec>;

// The difference between a region and the exact one.
struct Difference {
  double area{};      // area of the symmetric difference, square lattice units
  double distance{};  // the largest distance from its corners to the exact boundary, lattice units
  bool crossed{};     // a ring crosses itself and was left out
};

// The Minkowski sum of two polygons.
class ExactSum {
 public:
  // Convolution is much faster, but CGAL 5.5 occasionally fills a hole that should remain; the union of the sums of
  // convex parts does not.
  enum class Method { kConvolution, kDecomposition };
  ExactSum(const Polygon& p, const Polygon& q, Method method);
  ~ExactSum();
  ExactSum(const ExactSum&) = delete;
  ExactSum& operator=(const ExactSum&) = delete;

  // The edges of the outer boundary and of the holes, rounded to doubles.
  [[nodiscard]] const std::vector<Segment>& boundary() const { return boundary_; }
  [[nodiscard]] double perimeter() const;
  [[nodiscard]] std::size_t holes() const;
  [[nodiscard]] geometry::Location locate(RealVec point) const;
  // The difference between the union of the other sum's rings and this sum.
  [[nodiscard]] Difference difference(const minkowski::MinkowskiSum& other) const;
  // The difference between a region, given as rings (outlines counter-clockwise, holes clockwise), and this sum.
  [[nodiscard]] Difference difference(std::span<const Polygon> rings) const;

 private:
  struct Region;
  std::unique_ptr<const Region> region_;
  std::vector<Segment> boundary_;
};

}  // namespace selvage::test
