#include "core/geometry/overlap.h"

#include <boost/container/small_vector.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

namespace selvage::geometry {
namespace {

// An edge of one polygon in the common frame of the pair, and the vertex before it, which the cone test needs.
struct Edge {
  Vec before, from, to;
  Box box;
};

Box box_of_segment(Vec a, Vec b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

using Edges = boost::container::small_vector<Edge, 24>;  // inline capacity; most pairs have fewer edges near each other

// A bit mask of the sides of the box that the point lies strictly outside of.
unsigned sides_beyond(const Box& box, Vec point) {
  return static_cast<unsigned>(point.x < box.low.x) | static_cast<unsigned>(point.x > box.high.x) << 1U |
         static_cast<unsigned>(point.y < box.low.y) << 2U | static_cast<unsigned>(point.y > box.high.y) << 3U;
}

// The edges of `polygon` whose boxes touch `window`: an edge is left out when both of its ends are outside the same
// side.
Edges edges_near(const PlacedPolygon& polygon, const Box& window) {
  Edges edges;
  const auto& v = polygon.vertices;
  const std::size_t n = v.size();
  const Box local = window.moved(-polygon.at);
  const unsigned first = sides_beyond(local, v[0]);
  unsigned here = first;
  for (std::size_t i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const unsigned next = last ? first : sides_beyond(local, v[i + 1]);
    if ((here & next) == 0) {
      const Vec a = v[i] + polygon.at;
      const Vec b = v[last ? 0 : i + 1] + polygon.at;
      edges.push_back({v[i == 0 ? n - 1 : i - 1] + polygon.at, a, b, box_of_segment(a, b)});
    }
    here = next;
  }
  return edges;
}

// True when direction d lies in the half-open arc [start, end), counter-clockwise.  REQUIRES: start and end do not
// point in the same direction.
bool in_arc(Vec start, Vec end, Vec d) {
  const Wide turn = cross(start, end);
  if (turn > 0) return cross(start, d) >= 0 && cross(d, end) > 0;
  if (turn < 0) return !(cross(end, d) >= 0 && cross(d, start) > 0);
  const Wide side = cross(start, d);
  return side > 0 || (side == 0 && dot(start, d) > 0);
}

// The interior of a polygon near one of its boundary points: the open arc from `start` to `end`.
struct Cone {
  Vec start, end;
};
bool cones_meet(const Cone& a, const Cone& b) {
  return in_arc(a.start, a.end, b.start) || in_arc(b.start, b.end, a.start);
}
Cone cone_at(const Edge& edge, Vec point) {
  const Vec forward = edge.to - edge.from;
  return {forward, point == edge.from ? edge.before - edge.from : -forward};
}

bool on_half_open(const Edge& edge, Vec point,
                  int side) {  // true for a point on [from, to), given its side of the edge's line
  return side == 0 && point != edge.to && edge.box.touches({point, point});
}

enum class Meeting { kNone, kTouch, kOverlap };

// How the two boundaries meet at one pair of edges.
Meeting meeting_of(const Edge& e, const Edge& f) {
  const int f_from = side_of(e.from, e.to, f.from);
  const int f_to = side_of(e.from, e.to, f.to);
  if (f_from * f_to > 0) return Meeting::kNone;
  const int e_from = side_of(f.from, f.to, e.from);
  const int e_to = side_of(f.from, f.to, e.to);
  if (e_from * e_to > 0) return Meeting::kNone;
  if (f_from * f_to < 0 && e_from * e_to < 0) return Meeting::kOverlap;
  Meeting meeting = Meeting::kNone;
  for (const auto& [point, touches] :
       {std::pair{f.from, on_half_open(e, f.from, f_from)}, std::pair{e.from, on_half_open(f, e.from, e_from)}}) {
    if (!touches) continue;
    if (cones_meet(cone_at(e, point), cone_at(f, point))) return Meeting::kOverlap;
    meeting = Meeting::kTouch;
  }
  return meeting;
}

Box common_window(const PlacedPolygon& p, const PlacedPolygon& q) {
  const Box a = p.placed_box();
  const Box b = q.placed_box();
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

// True when q contains p, given that their boundaries share no point.
bool contains(const PlacedPolygon& q, const PlacedPolygon& p) {
  const Box outer = q.placed_box();
  const Box inner = p.placed_box();
  const bool may = outer.low.x < inner.low.x && outer.low.y < inner.low.y && inner.high.x < outer.high.x &&
                   inner.high.y < outer.high.y;
  return may && locate(p.vertices.front() + p.at - q.at, q.vertices) == Location::kInside;
}

using Integer256 = boost::multiprecision::int256_t;

Integer256 widened(Wide value) {
  const bool negative = value < 0;
  const auto magnitude = negative ? -static_cast<unsigned __int128>(value) : static_cast<unsigned __int128>(value);
  Integer256 wide = static_cast<std::uint64_t>(magnitude >> 64);
  wide = (wide << 64) + static_cast<std::uint64_t>(magnitude);
  return negative ? Integer256{-wide} : wide;
}

// True when `point` is nearer than `distance` to the closed segment.
bool nearer_than(Vec point, Vec from, Vec to, Coord distance) {
  const Vec along = to - from;
  const Vec out = point - from;
  const Wide reach = static_cast<Wide>(distance) * distance;
  const Wide projection = dot(out, along);
  if (projection <= 0) return dot(out, out) < reach;
  const Wide length = dot(along, along);
  if (projection >= length) return dot(point - to, point - to) < reach;
  // Tests |area| / |along| < distance in doubles; when the two sides agree to within rounding, exact 256-bit integers
  // decide.
  const Wide area = cross(along, out);
  const double left = std::abs(static_cast<double>(area));
  const double right = static_cast<double>(distance) * std::sqrt(static_cast<double>(length));
  if (left < right * (1 - 1e-12)) return true;
  if (left > right * (1 + 1e-12)) return false;
  const Integer256 a = widened(area);
  return Integer256{a * a} < Integer256{widened(reach) * widened(length)};
}

struct Real {
  double x{}, y{};
};
Real nearest_on_segment(Real point, const Edge& edge) {
  const double ax = static_cast<double>(edge.from.x);
  const double ay = static_cast<double>(edge.from.y);
  const double dx = static_cast<double>(edge.to.x) - ax;
  const double dy = static_cast<double>(edge.to.y) - ay;
  const double t = std::clamp(((point.x - ax) * dx + (point.y - ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return {ax + t * dx, ay + t * dy};
}
double squared(Real a, Real b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

// The x coordinates, sorted, at which the horizontal line at y crosses the polygon; each consecutive pair bounds an
// interior stretch.
std::vector<double> crossings_at(const PlacedPolygon& polygon, double y) {
  std::vector<double> xs;
  const auto& v = polygon.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec a = v[i] + polygon.at;
    const Vec b = v[i + 1 == v.size() ? 0 : i + 1] + polygon.at;
    const auto ay = static_cast<double>(a.y);
    const auto by = static_cast<double>(b.y);
    if ((ay > y) == (by > y)) continue;
    xs.push_back(static_cast<double>(a.x) + (y - ay) / (by - ay) * static_cast<double>(b.x - a.x));
  }
  std::sort(xs.begin(), xs.end());
  return xs;
}

// The widest stretch of the horizontal line at y that lies inside both polygons: its middle and its width.
std::pair<double, double> widest_common_stretch(const PlacedPolygon& p, const PlacedPolygon& q, double y) {
  const auto ps = crossings_at(p, y);
  const auto qs = crossings_at(q, y);
  std::pair<double, double> widest{0.0, 0.0};
  for (std::size_t i = 0; i + 1 < ps.size(); i += 2) {
    for (std::size_t j = 0; j + 1 < qs.size(); j += 2) {
      const double low = std::max(ps[i], qs[j]);
      const double high = std::min(ps[i + 1], qs[j + 1]);
      if (high - low > widest.second) widest = {(low + high) / 2, high - low};
    }
  }
  return widest;
}

}  // namespace

bool overlap(const PlacedPolygon& p, const PlacedPolygon& q) {
  if (!p.placed_box().overlaps(q.placed_box())) return false;
  const Box window = common_window(p, q);
  const auto p_edges = edges_near(p, window);
  const auto q_edges = edges_near(q, window);
  bool touching = false;
  for (const Edge& e : p_edges) {
    for (const Edge& f : q_edges) {
      if (!e.box.touches(f.box)) continue;
      const Meeting meeting = meeting_of(e, f);
      if (meeting == Meeting::kOverlap) return true;
      touching = touching || meeting == Meeting::kTouch;
    }
  }
  return !touching && (contains(q, p) || contains(p, q));
}

bool closer_than(const PlacedPolygon& p, const PlacedPolygon& q, Coord distance) {
  if (!p.placed_box().grown(distance).overlaps(q.placed_box())) return false;
  if (overlap(p, q)) return true;
  const auto p_edges = edges_near(p, q.placed_box().grown(distance));
  const auto q_edges = edges_near(q, p.placed_box().grown(distance));
  for (const Edge& e : p_edges) {
    const Box reach = e.box.grown(distance);
    for (const Edge& f : q_edges) {
      if (!reach.touches(f.box)) continue;
      if (nearer_than(e.from, f.from, f.to, distance) || nearer_than(e.to, f.from, f.to, distance) ||
          nearer_than(f.from, e.from, e.to, distance) || nearer_than(f.to, e.from, e.to, distance)) {
        return true;
      }
    }
  }
  return false;
}

std::optional<RealVec> common_point(const PlacedPolygon& p, const PlacedPolygon& q) {
  if (!overlap(p, q)) return std::nullopt;
  // Between two neighbouring levels (the heights of vertices and crossings) the common stretches change linearly, so
  // one test halfway between the levels is enough.
  const Box window = common_window(p, q);
  std::vector<double> levels{static_cast<double>(window.low.y), static_cast<double>(window.high.y)};
  const auto p_edges = edges_near(p, window);
  const auto q_edges = edges_near(q, window);
  for (const Edge& e : p_edges) levels.push_back(static_cast<double>(e.from.y));
  for (const Edge& f : q_edges) levels.push_back(static_cast<double>(f.from.y));
  for (const Edge& e : p_edges) {
    for (const Edge& f : q_edges) {
      const Wide turn = cross(e.to - e.from, f.to - f.from);
      if (turn == 0 || !e.box.touches(f.box)) continue;
      const double t = static_cast<double>(cross(f.from - e.from, f.to - f.from)) / static_cast<double>(turn);
      if (t >= 0 && t <= 1) {
        levels.push_back(static_cast<double>(e.from.y) + t * static_cast<double>(e.to.y - e.from.y));
      }
    }
  }
  std::sort(levels.begin(), levels.end());
  RealVec best{static_cast<double>(window.low.x + window.high.x) / 2,
               static_cast<double>(window.low.y + window.high.y) / 2};
  double widest = 0;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    const double y = (levels[k] + levels[k + 1]) / 2;
    if (y <= static_cast<double>(window.low.y) || y >= static_cast<double>(window.high.y)) continue;
    const auto [x, width] = widest_common_stretch(p, q, y);
    const double size = std::min(width, levels[k + 1] - levels[k]);
    if (size > widest) {
      widest = size;
      best = {x, y};
    }
  }
  return best;
}

RealVec nearest_point(const PlacedPolygon& p, const PlacedPolygon& q) {
  const Box everywhere = p.placed_box().grown(kLatticeLimit);
  const auto p_edges = edges_near(p, everywhere);
  const auto q_edges = edges_near(q, q.placed_box());
  double best = std::numeric_limits<double>::infinity();
  RealVec middle;
  const auto consider = [&](const Edge& from, const Edge& to) {
    const Real a{static_cast<double>(from.from.x), static_cast<double>(from.from.y)};
    const Real b = nearest_on_segment(a, to);
    if (const double d = squared(a, b); d < best) {
      best = d;
      middle = {(a.x + b.x) / 2, (a.y + b.y) / 2};
    }
  };
  for (const Edge& e : p_edges) {
    for (const Edge& f : q_edges) {
      consider(e, f);
      consider(f, e);
    }
  }
  return middle;
}

}  // namespace selvage::geometry
