#include "tests/support/exact.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace selvage::test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using Outer = CGAL::Polygon_2<Kernel>;
using WithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using Set = CGAL::Polygon_set_2<Kernel>;

// A coordinate below 2^53 is represented exactly by a double.
Point point(Vec v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}
Point point(RealVec v) {
  return {v.x, v.y};
}
RealVec rounded(const Point& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

Outer polygon_of(std::span<const Vec> vertices) {
  Outer polygon;
  for (const Vec v : vertices) polygon.push_back(point(v));
  return polygon;
}

geometry::Location location(CGAL::Bounded_side side) {
  if (side == CGAL::ON_BOUNDARY) return geometry::Location::kBoundary;
  return side == CGAL::ON_BOUNDED_SIDE ? geometry::Location::kInside : geometry::Location::kOutside;
}

double area_of(const WithHoles& region) {
  double area = CGAL::to_double(region.outer_boundary().area());
  for (const Outer& hole : region.holes()) area -= std::abs(CGAL::to_double(hole.area()));
  return area;
}

WithHoles sum_of(const Outer& p, const Outer& q, ExactSum::Method method) {
  if (method == ExactSum::Method::kConvolution) return CGAL::minkowski_sum_2(p, q);
  return CGAL::minkowski_sum_2(p, q, CGAL::Small_side_angle_bisector_decomposition_2<Kernel>{});
}

// The region that a ring of a star-shaped sum encloses.  When rounding makes edges of the ring cross by a unit, it is
// the union of the triangles between the centre and each edge.
void append_region(const minkowski::convolution::StarSum& ring, std::vector<Outer>& regions) {
  Outer whole;
  for (const minkowski::convolution::SumEdge& e : ring.edges) whole.push_back(point(e.from));
  if (whole.is_simple() && whole.orientation() == CGAL::COUNTERCLOCKWISE) {
    regions.push_back(whole);
    return;
  }
  for (const minkowski::convolution::SumEdge& e : ring.edges) {
    Outer triangle;
    for (const Point& corner : {point(ring.centre), point(e.from), point(e.to)}) triangle.push_back(corner);
    if (triangle.is_simple() && triangle.orientation() == CGAL::COUNTERCLOCKWISE) regions.push_back(triangle);
  }
}

// Splits a ring that touches itself at vertices into rings that do not.
std::vector<Polygon> loops_of(const Polygon& ring) {
  std::vector<Polygon> loops;
  Polygon open;
  for (const Vec v : ring) {
    const auto before = std::find(open.begin(), open.end(), v);
    if (before != open.end()) {
      if (open.end() - before > 2) loops.emplace_back(before, open.end());
      open.erase(before, open.end());
    }
    open.push_back(v);
  }
  if (open.size() > 2) loops.push_back(std::move(open));
  return loops;
}

double distance_to(std::span<const Segment> boundary, RealVec point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : boundary) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = dx * dx + dy * dy;
    const double along = length > 0 ? std::clamp(((point.x - a.x) * dx + (point.y - a.y) * dy) / length, 0.0, 1.0) : 0;
    least = std::min(least, std::hypot(point.x - a.x - along * dx, point.y - a.y - along * dy));
  }
  return least;
}

}  // namespace

bool is_simple_exactly(std::span<const Vec> vertices) {
  return polygon_of(vertices).is_simple();
}

geometry::Location locate_exactly(RealVec at, const Polygon& polygon) {
  return location(polygon_of(polygon).bounded_side(point(at)));
}

bool interiors_meet(const Polygon& p, const Polygon& q) {
  return CGAL::do_intersect(polygon_of(p), polygon_of(q), CGAL::Tag_false{});
}

bool holds(const Polygon& outer, const Polygon& inner) {
  std::vector<WithHoles> outside;
  CGAL::difference(polygon_of(inner), polygon_of(outer), std::back_inserter(outside), CGAL::Tag_false{});
  return outside.empty();
}

int compare_distance(const Polygon& p, const Polygon& q, Coord distance) {
  const Outer a = polygon_of(p);
  const Outer b = polygon_of(q);
  const Kernel::FT reach{static_cast<double>(distance)};
  CGAL::Comparison_result least = CGAL::LARGER;
  for (auto e = a.edges_begin(); e != a.edges_end(); ++e) {
    for (auto f = b.edges_begin(); f != b.edges_end(); ++f) {
      least = std::min(least, CGAL::compare(CGAL::squared_distance(*e, *f), reach * reach));
    }
  }
  return static_cast<int>(least);
}

std::vector<double> areas_left_over(const Box& box, std::span<const Polygon> polygons) {
  std::vector<Outer> covers;
  for (const Polygon& polygon : polygons) covers.push_back(polygon_of(polygon));
  Set covered;
  covered.join(covers.begin(), covers.end());
  const Polygon whole{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
  Set open{polygon_of(whole)};
  open.difference(covered);
  std::vector<WithHoles> regions;
  open.polygons_with_holes(std::back_inserter(regions));
  std::vector<double> areas;
  for (const WithHoles& region : regions) areas.push_back(area_of(region));
  std::sort(areas.rbegin(), areas.rend());
  return areas;
}

struct ExactSum::Region {
  WithHoles sum;
  // The difference of the union of the outlines, without the holes, from this region.
  [[nodiscard]] Difference difference_of(const std::vector<Outer>& outlines, const std::vector<Outer>& holes,
                                         std::span<const Segment> boundary) const;
};

ExactSum::ExactSum(const Polygon& p, const Polygon& q, Method method)
    : region_{std::make_unique<const Region>(Region{sum_of(polygon_of(p), polygon_of(q), method)})} {
  const auto append = [&](const Outer& ring) {
    for (auto e = ring.edges_begin(); e != ring.edges_end(); ++e) {
      boundary_.emplace_back(rounded(e->source()), rounded(e->target()));
    }
  };
  append(region_->sum.outer_boundary());
  for (const Outer& hole : region_->sum.holes()) append(hole);
}

ExactSum::~ExactSum() = default;

double ExactSum::perimeter() const {
  double length = 0;
  for (const auto& [a, b] : boundary_) length += std::hypot(b.x - a.x, b.y - a.y);
  return length;
}

std::size_t ExactSum::holes() const {
  return region_->sum.number_of_holes();
}

geometry::Location ExactSum::locate(RealVec at) const {
  const Point p = point(at);
  const geometry::Location outer = location(region_->sum.outer_boundary().bounded_side(p));
  if (outer != geometry::Location::kInside) return outer;
  for (const Outer& hole : region_->sum.holes()) {
    const geometry::Location in_hole = location(hole.bounded_side(p));
    if (in_hole == geometry::Location::kBoundary) return geometry::Location::kBoundary;
    if (in_hole == geometry::Location::kInside) return geometry::Location::kOutside;
  }
  return geometry::Location::kInside;
}

Difference ExactSum::Region::difference_of(const std::vector<Outer>& outlines, const std::vector<Outer>& holes,
                                           std::span<const Segment> boundary) const {
  Set united;
  united.join(outlines.begin(), outlines.end());
  for (const Outer& hole : holes) united.difference(hole);
  united.symmetric_difference(Set{sum});
  std::vector<WithHoles> rest;
  united.polygons_with_holes(std::back_inserter(rest));
  Difference difference;
  for (const WithHoles& part : rest) {
    difference.area += area_of(part);
    for (const Point& corner : part.outer_boundary().vertices()) {
      difference.distance = std::max(difference.distance, distance_to(boundary, rounded(corner)));
    }
  }
  return difference;
}

Difference ExactSum::difference(const minkowski::MinkowskiSum& other) const {
  std::vector<Outer> regions;
  for (const minkowski::convolution::StarSum& ring : other.rings()) append_region(ring, regions);
  return region_->difference_of(regions, {}, boundary_);
}

Difference ExactSum::difference(std::span<const Polygon> rings) const {
  std::vector<Outer> outlines;
  std::vector<Outer> holes;
  bool crossed = false;
  for (const Polygon& ring : rings) {
    for (const Polygon& loop : loops_of(ring)) {
      Outer whole = polygon_of(loop);
      if (!whole.is_simple()) {
        crossed = true;
      } else if (whole.orientation() == CGAL::COUNTERCLOCKWISE) {
        outlines.push_back(std::move(whole));
      } else if (whole.orientation() == CGAL::CLOCKWISE) {
        whole.reverse_orientation();
        holes.push_back(std::move(whole));
      }
    }
  }
  Difference difference = region_->difference_of(outlines, holes, boundary_);
  difference.crossed = crossed;
  return difference;
}

}  // namespace selvage::test
