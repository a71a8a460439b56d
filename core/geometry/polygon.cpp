#include "core/geometry/polygon.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace selvage::geometry {
namespace {

// The edge from p to q by the numbers of these vertices, counted from 0: lattice coordinates mean nothing to an author
// who drew the outline in another unit.
std::string edge_name(std::span<const Vec> vertices, Vec p, Vec q) {
  const auto number = [&](Vec v) {
    return std::to_string(std::find(vertices.begin(), vertices.end(), v) - vertices.begin());
  };
  return "edge from vertex " + number(p) + " to vertex " + number(q);
}

// Removes repeated vertices, vertices in the middle of straight edges and tips of zero-width spikes until none is left.
Polygon without_redundant_vertices(std::span<const Vec> vertices, Repairs& repairs) {
  Polygon kept;
  kept.reserve(vertices.size());
  // True when the last kept vertex is redundant before `next`; counts the repair.
  const auto tail_is_redundant = [&kept, &repairs](Vec next) {
    if (kept.back() == next) {
      ++repairs.duplicate_vertices;
      return true;
    }
    if (kept.size() >= 2 && side_of(kept[kept.size() - 2], kept.back(), next) == 0) {
      ++repairs.collinear_vertices;
      return true;
    }
    return false;
  };
  for (const Vec v : vertices) {
    while (!kept.empty() && tail_is_redundant(v)) kept.pop_back();
    kept.push_back(v);
  }
  // Redundant vertices may remain where the end of the list meets its start.
  std::size_t first = 0;
  for (bool changed = true; changed && kept.size() - first >= 3;) {
    changed = false;
    if (tail_is_redundant(kept[first])) {
      kept.pop_back();
      changed = true;
    } else if (side_of(kept.back(), kept[first], kept[first + 1]) == 0) {
      ++repairs.collinear_vertices;
      ++first;
      changed = true;
    }
  }
  kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first));
  return kept;
}

// Two edges that share a point although they are not neighbours, found by a sweep over the edges' x ranges; {0, 0} when
// there are none.
std::pair<std::size_t, std::size_t> meeting_edges(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  const auto end_of = [&](std::size_t i) { return polygon[i + 1 == n ? 0 : i + 1]; };
  std::vector<std::size_t> by_x(n);
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  const auto low_x = [&](std::size_t i) { return std::min(polygon[i].x, end_of(i).x); };
  std::sort(by_x.begin(), by_x.end(), [&](auto i, auto j) { return low_x(i) < low_x(j); });
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = by_x[k];
    const Coord high_x = std::max(polygon[i].x, end_of(i).x);
    const Coord low_y = std::min(polygon[i].y, end_of(i).y);
    const Coord high_y = std::max(polygon[i].y, end_of(i).y);
    for (std::size_t m = k + 1; m < n && low_x(by_x[m]) <= high_x; ++m) {
      const std::size_t j = by_x[m];
      if (std::max(polygon[j].y, end_of(j).y) < low_y || std::min(polygon[j].y, end_of(j).y) > high_y) continue;
      const std::size_t apart = i < j ? j - i : i - j;
      if (apart == 1 || apart == n - 1)
        continue;  // neighbouring edges share only their vertex, since no vertex is redundant
      if (segments_meet(polygon[i], end_of(i), polygon[j], end_of(j))) return std::minmax(i, j);
    }
  }
  return {0, 0};
}

}  // namespace

Wide doubled_area(std::span<const Vec> polygon) {
  Wide sum = 0;
  if (polygon.empty()) return sum;
  const Vec origin = polygon.front();
  for (std::size_t i = 2; i < polygon.size(); ++i) sum += cross(polygon[i - 1] - origin, polygon[i] - origin);
  return sum;
}

double area_of(std::span<const Vec> polygon) {
  return static_cast<double>(doubled_area(polygon)) / 2;
}

bool is_convex(std::span<const Vec> polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (side_of(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) <= 0) return false;
  }
  return n >= 3;
}

Polygon moved(Polygon polygon, Vec by) {
  for (Vec& vertex : polygon) vertex = vertex + by;
  return polygon;
}

Location locate(Vec point, std::span<const Vec> polygon) {
  bool inside = false;
  Vec a = polygon.back();
  for (const Vec b : polygon) {
    const auto [low_y, high_y] = std::minmax(a.y, b.y);
    if (low_y <= point.y && point.y <= high_y) {
      const int side = side_of(a, b, point);
      if (side == 0 && std::min(a.x, b.x) <= point.x && point.x <= std::max(a.x, b.x)) return Location::kBoundary;
      if ((a.y > point.y) != (b.y > point.y) && (side > 0) == (b.y > a.y)) inside = !inside;
    }
    a = b;
  }
  return inside ? Location::kInside : Location::kOutside;
}

Result<CleanPolygon> clean_polygon(std::span<const Vec> vertices) {
  if (vertices.size() > 1 && vertices.front() == vertices.back()) vertices = vertices.first(vertices.size() - 1);
  if (vertices.size() > kMaxVertices) {
    return Error{
        ErrorCode::kTooManyVertices,
        std::to_string(vertices.size()) + " vertices; at most " + std::to_string(kMaxVertices) + " are allowed",
        {}};
  }
  if (vertices.size() < 3) {
    return Error{ErrorCode::kTooFewVertices, std::to_string(vertices.size()) + " vertices; at least 3 are needed", {}};
  }
  CleanPolygon clean;
  clean.polygon = without_redundant_vertices(vertices, clean.repairs);
  if (clean.polygon.size() < 3) {
    const bool all_equal = clean.polygon.size() <= 1 || clean.repairs.duplicate_vertices + 2 >= vertices.size();
    return Error{all_equal ? ErrorCode::kTooFewVertices : ErrorCode::kZeroArea,
                 "the outline has no area: at least 3 different vertices, not all on one line, are needed",
                 {}};
  }
  if (const auto [i, j] = meeting_edges(clean.polygon); i != j) {
    const auto& p = clean.polygon;
    return Error{ErrorCode::kSelfIntersecting,
                 "the outline must not cross or touch itself: its " + edge_name(vertices, p[i], p[(i + 1) % p.size()]) +
                     " meets its " + edge_name(vertices, p[j], p[(j + 1) % p.size()]) + " (counted from 0)",
                 {}};
  }
  const Wide area = doubled_area(clean.polygon);
  if (area < 0) {
    std::reverse(clean.polygon.begin() + 1, clean.polygon.end());
    clean.repairs.reversed = true;
  }
  return clean;
}

Polygon normal_form(Polygon polygon, Vec by) {
  for (Vec& vertex : polygon) vertex = vertex + by;
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  return polygon;
}

}  // namespace selvage::geometry
