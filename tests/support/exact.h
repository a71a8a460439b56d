// Exact answers from CGAL, an independent witness: what ours are judged by.  Only tests see CGAL's set
// operations.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/minkowski/sum.h"
#include "core/outline/star.h"

namespace selvage::test {

// Of any closed vertex list.
[[nodiscard]] bool is_simple_exactly(std::span<const Vec> vertices);
// Where a point between lattice points lies; the double is taken as the number it is.
[[nodiscard]] geometry::Location locate_exactly(RealVec point, const Polygon& polygon);
// True when the intersection of the two has an area.
[[nodiscard]] bool interiors_meet(const Polygon& p, const Polygon& q);
// True when no part of `inner` that has an area lies outside `outer`.
[[nodiscard]] bool holds(const Polygon& outer, const Polygon& inner);
// The sign of (distance of the closed polygons) - distance: -1 nearer, 0 exactly as far, 1 farther.
// REQUIRES: their interiors do not meet.
[[nodiscard]] int compare_distance(const Polygon& p, const Polygon& q, Coord distance);

// The areas of the connected regions of the box that no polygon covers, largest first.
[[nodiscard]] std::vector<double> areas_left_over(const Box& box, std::span<const Polygon> polygons);

using Segment = std::pair<RealVec, RealVec>;

// Where a region is not the exact one.
struct Difference {
  double area{};      // of the symmetric difference, square lattice units
  double distance{};  // from its farthest corner to the exact boundary, lattice units
  bool crossed{};     // a ring crosses itself: it was left out
};

// The Minkowski sum of two polygons.
class ExactSum {
 public:
  // The convolution is much the faster one, but CGAL 5.5 now and then fills in a hole that it should not; the
  // union of the sums of convex parts does not.
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
  // Where the union of the other's rings differs from this.
  [[nodiscard]] Difference difference(const minkowski::MinkowskiSum& other) const;
  // Where a region does, given as rings: outlines counter-clockwise, holes clockwise.
  [[nodiscard]] Difference difference(std::span<const Polygon> rings) const;

 private:
  struct Region;
  std::unique_ptr<const Region> region_;
  std::vector<Segment> boundary_;
};

}  // namespace selvage::test
