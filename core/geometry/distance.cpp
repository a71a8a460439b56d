#include "core/geometry/distance.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace selvage::geometry {
namespace {

struct Segment {
  Vec from, to;
  Box box;
};

// The Euclidean distance between two boxes.
double gap_between(const Box& a, const Box& b) {
  const auto x = static_cast<double>(std::max({a.low.x - b.high.x, b.low.x - a.high.x, Coord{0}}));
  const auto y = static_cast<double>(std::max({a.low.y - b.high.y, b.low.y - a.high.y, Coord{0}}));
  return std::sqrt(x * x + y * y);
}

// The edges of the polygon whose boxes are nearer than `reach` to the box `other`.
std::vector<Segment> edges_near(const PlacedPolygon& polygon, const Box& other, double reach) {
  std::vector<Segment> edges;
  const auto& v = polygon.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec a = v[i] + polygon.at;
    const Vec b = v[i + 1 == v.size() ? 0 : i + 1] + polygon.at;
    const Box box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
    if (gap_between(box, other) < reach) edges.push_back({a, b, box});
  }
  return edges;
}

double length_of_vector(Vec v) {
  return std::sqrt(static_cast<double>(dot(v, v)));
}

double distance_to_edge(Vec point, const Segment& edge) {
  const Vec along = edge.to - edge.from;
  const Vec out = point - edge.from;
  const Wide projection = dot(out, along);
  if (projection <= 0) return length_of_vector(out);
  if (projection >= dot(along, along)) return length_of_vector(point - edge.to);
  return std::abs(static_cast<double>(cross(along, out))) / length_of_vector(along);
}

}  // namespace

double distance_within(const PlacedPolygon& p, const PlacedPolygon& q, double reach) {
  const Box p_box = p.placed_box();
  const Box q_box = q.placed_box();
  if (gap_between(p_box, q_box) >= reach) return reach;
  if (overlap(p, q)) return 0;
  const auto p_edges = edges_near(p, q_box, reach);
  const auto q_edges = edges_near(q, p_box, reach);
  double least = reach;
  for (const Segment& e : p_edges) {
    if (gap_between(e.box, q_box) >= least) continue;
    for (const Segment& f : q_edges) {
      // The distance of two edges that do not cross is attained at an end of one of them.
      if (gap_between(e.box, f.box) >= least) continue;
      least = std::min({least, distance_to_edge(e.from, f), distance_to_edge(e.to, f), distance_to_edge(f.from, e),
                        distance_to_edge(f.to, e)});
    }
  }
  return least;
}

Coord whole_distance_within(const PlacedPolygon& p, const PlacedPolygon& q, Coord reach) {
  auto whole = static_cast<Coord>(distance_within(p, q, static_cast<double>(reach)));
  while (whole > 0 && closer_than(p, q, whole)) --whole;
  while (whole < reach && !closer_than(p, q, whole + 1)) ++whole;
  return whole;
}

}  // namespace selvage::geometry
