#include "core/outline/narrow.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/real_plane.h"

namespace selvage::outline {
namespace {

constexpr double kOpposite = -0.5;  // the largest cosine between the normals of edges that face away from each other

struct Edge {
  Vec from, to;
  RealVec along;  // unit
  double length{};
  Box box;
};

Edge edge_between(Vec from, Vec to) {
  const RealVec d = real(to - from);
  const double length = std::hypot(d.x, d.y);
  return {from, to, {d.x / length, d.y / length}, length, geometry::box_of(std::vector<Vec>{from, to})};
}

// True when the other edge runs beside this one, on the inner side, and is everywhere nearer than `width`.
bool is_narrow(const Edge& edge, const Edge& other, double width) {
  const double cosine = edge.along.x * other.along.x + edge.along.y * other.along.y;
  if (cosine > kOpposite) return false;
  // Along this edge and across it to the left, where the interior is.
  const auto seen = [&](Vec v) {
    const RealVec by = real(v - edge.from);
    return RealVec{by.x * edge.along.x + by.y * edge.along.y, by.y * edge.along.x - by.x * edge.along.y};
  };
  const RealVec end = seen(other.from);  // it runs backwards
  const RealVec start = seen(other.to);
  const double low = std::max(0.0, start.x);
  const double high = std::min(edge.length, end.x);
  if (low >= high) return false;
  const auto across = [&](double x) { return start.y + (x - start.x) / (end.x - start.x) * (end.y - start.y); };
  return std::min(across(low), across(high)) >= 0 && std::max(across(low), across(high)) < width;
}

}  // namespace

std::optional<Vec> narrow_part(const Polygon& polygon, Coord width) {
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    edges.push_back(edge_between(polygon[k], polygon[k + 1 == polygon.size() ? 0 : k + 1]));
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.box.low.x != b.box.low.x ? a.box.low.x < b.box.low.x : a.from < b.from;
  });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Box reach = edges[i].box.grown(width);
    for (std::size_t j = i + 1; j < edges.size() && edges[j].box.low.x <= reach.high.x; ++j) {
      if (!reach.touches(edges[j].box)) continue;
      if (is_narrow(edges[i], edges[j], static_cast<double>(width))) return edges[i].from;
    }
  }
  return std::nullopt;
}

}  // namespace selvage::outline
