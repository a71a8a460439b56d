#include "tests/judge/exact_pairs.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace selvage::test {
namespace {

using Wider = boost::multiprecision::checked_int256_t;

struct Edge {
  Vec from, to;
  [[nodiscard]] Vec along() const { return {to.x - from.x, to.y - from.y}; }
  [[nodiscard]] bool near(const Edge& other, Coord reach) const {
    const auto apart = [reach](Coord a, Coord b, Coord c, Coord d) {
      return std::max(a, b) + reach < std::min(c, d) || std::max(c, d) + reach < std::min(a, b);
    };
    return !apart(from.x, to.x, other.from.x, other.to.x) && !apart(from.y, to.y, other.from.y, other.to.y);
  }
};

Wide product(Coord a, Coord b) {
  return static_cast<Wide>(a) * b;
}
// Positive when c lies to the left of the edge.
Wide left_of(const Edge& e, Vec c) {
  return product(e.to.x - e.from.x, c.y - e.from.y) - product(e.to.y - e.from.y, c.x - e.from.x);
}
int sign(Wide w) {
  return w > 0 ? 1 : w < 0 ? -1 : 0;
}
// The coordinate of the point along the edge, times the edge's length.
Wide advance(const Edge& e, Vec c) {
  return product(e.to.x - e.from.x, c.x - e.from.x) + product(e.to.y - e.from.y, c.y - e.from.y);
}
Wide squared_length(Vec v) {
  return product(v.x, v.x) + product(v.y, v.y);
}
bool lies_on(const Edge& e, Vec c) {
  const Wide at = advance(e, c);
  return left_of(e, c) == 0 && at >= 0 && at <= squared_length(e.along());
}
bool cross_properly(const Edge& e, const Edge& f) {
  return sign(left_of(e, f.from)) * sign(left_of(e, f.to)) < 0 && sign(left_of(f, e.from)) * sign(left_of(f, e.to)) < 0;
}

std::vector<Edge> edges_of(const Polygon& p) {
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < p.size(); ++k) edges.push_back({p[k], p[(k + 1) % p.size()]});
  return edges;
}

// True when the polygon, given by its edges scaled by two, winds around a point, also scaled by two, that is not on its
// boundary.
bool winds_about(const std::vector<Edge>& doubled, Vec c) {
  int winding = 0;
  for (const Edge& e : doubled) {
    if (lies_on(e, c)) return false;
    if (e.from.y <= c.y && e.to.y > c.y && left_of(e, c) > 0) ++winding;
    if (e.from.y > c.y && e.to.y <= c.y && left_of(e, c) < 0) --winding;
  }
  return winding != 0;
}

std::vector<Edge> doubled(std::vector<Edge> edges) {
  for (Edge& e : edges) e = {{2 * e.from.x, 2 * e.from.y}, {2 * e.to.x, 2 * e.to.y}};
  return edges;
}

// True when some part of p's boundary, divided at q's vertices, lies inside q.  REQUIRES: no edges cross properly.
bool runs_inside(const std::vector<Edge>& p, const std::vector<Edge>& q) {
  const std::vector<Edge> twice = doubled(q);
  for (const Edge& e : p) {
    std::vector<Vec> cuts{e.from, e.to};
    for (const Edge& f : q) {
      if (lies_on(e, f.from)) cuts.push_back(f.from);
    }
    std::sort(cuts.begin(), cuts.end(), [&](Vec a, Vec b) { return advance(e, a) < advance(e, b); });
    // Where a vertex of p lies on q, p's boundary is divided already.
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const Vec middle{cuts[k].x + cuts[k + 1].x, cuts[k].y + cuts[k + 1].y};
      if (cuts[k] != cuts[k + 1] && winds_about(twice, middle)) return true;
    }
  }
  return false;
}

bool same_ring(const Polygon& p, const Polygon& q) {
  if (p.size() != q.size()) return false;
  const auto first = std::find(q.begin(), q.end(), p.front());
  if (first == q.end()) return false;
  const auto shift = static_cast<std::size_t>(first - q.begin());
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (p[k] != q[(k + shift) % q.size()]) return false;
  }
  return true;
}

bool point_nearer(const Edge& e, Vec c, Wide squared_distance) {
  const Wide at = advance(e, c);
  const Wide squared = squared_length(e.along());
  if (at <= 0) return squared_length({c.x - e.from.x, c.y - e.from.y}) < squared_distance;
  if (at >= squared) return squared_length({c.x - e.to.x, c.y - e.to.y}) < squared_distance;
  const Wider off{left_of(e, c)};
  return off * off < Wider{squared} * Wider{squared_distance};
}

constexpr Coord kParts = 16;  // of a lattice unit: the translations that are tried are multiples of a sixteenth

Polygon in_parts(Polygon polygon, Vec by) {
  for (Vec& v : polygon) v = {kParts * v.x + by.x, kParts * v.y + by.y};
  return polygon;
}

struct Fine {
  long double x{}, y{};
  friend Fine operator+(Fine a, Fine b) { return {a.x + b.x, a.y + b.y}; }
  friend Fine operator*(long double k, Fine a) { return {k * a.x, k * a.y}; }
  [[nodiscard]] long double length() const { return std::hypot(x, y); }
};
Fine fine(Vec v) {
  return {static_cast<long double>(v.x), static_cast<long double>(v.y)};
}

// A translation that may separate two polygons, and the direction in which nearby translations do so, too.
struct Way {
  Fine by, out;
};

// The translations of q at which a vertex of one polygon lies on an edge of the other, as segments with the overlap on
// their left, as far as they come within the distance of 0.
class Slides {
 public:
  Slides(const Polygon& p, const Polygon& q, Coord distance) : reach_{static_cast<long double>(distance) + 2} {
    for (const Edge& e : edges_of(p)) {
      for (const Edge& f : edges_of(q)) {
        add({{e.from.x - f.from.x, e.from.y - f.from.y}, {e.to.x - f.from.x, e.to.y - f.from.y}});
        add({{e.from.x - f.from.x, e.from.y - f.from.y}, {e.from.x - f.to.x, e.from.y - f.to.y}});
      }
    }
  }
  // The point of each segment that is nearest to 0.
  [[nodiscard]] std::vector<Way> feet() const {
    std::vector<Way> ways;
    for (const Edge& e : segments_) ways.push_back({nearest(e), out_of(e)});
    return ways;
  }
  // Where two segments cross, if the direction from 0 lies between their normals.
  [[nodiscard]] std::vector<Way> crossings() const {
    std::vector<Way> ways;
    for (const Edge& e : segments_) {
      for (const Edge& f : segments_) {
        const Wide turn = product(e.along().x, f.along().y) - product(e.along().y, f.along().x);
        if (turn <= 0 || !e.near(f, 1)) continue;
        const long double t = static_cast<long double>(left_of(f, e.from)) / static_cast<long double>(turn);
        const Fine at = fine(e.from) + t * fine(e.along());
        const Fine a = out_of(e);
        const Fine b = out_of(f);
        const bool between = at.x * b.y - at.y * b.x >= -1 && a.x * at.y - a.y * at.x >= -1;
        if (t > -0.01L && t < 1.01L && at.length() <= reach_ && between) ways.push_back({at, middle(a, b)});
      }
    }
    return ways;
  }

 private:
  static Fine nearest(const Edge& e) {
    const auto square = static_cast<long double>(squared_length(e.along()));
    const long double t = std::clamp(static_cast<long double>(advance(e, {0, 0})) / square, 0.0L, 1.0L);
    return fine(e.from) + t * fine(e.along());
  }
  static Fine out_of(const Edge& e) {
    const Fine along = fine(e.along());
    return (1 / along.length()) * Fine{along.y, -along.x};
  }
  static Fine middle(Fine a, Fine b) {
    const Fine sum = a + b;
    return sum.length() > 1e-9L ? (1 / sum.length()) * sum : a;
  }
  void add(const Edge& e) {
    if (nearest(e).length() <= reach_) segments_.push_back(e);
  }

  long double reach_;
  std::vector<Edge> segments_;
};

std::pair<Coord, Coord> extent_along(const Polygon& p, Coord Vec::*axis) {
  std::pair<Coord, Coord> extent{p.front().*axis, p.front().*axis};
  for (const Vec v : p) extent = {std::min(extent.first, v.*axis), std::max(extent.second, v.*axis)};
  return extent;
}

}  // namespace

bool interiors_share(const Polygon& p, const Polygon& q) {
  const std::vector<Edge> of_p = edges_of(p);
  const std::vector<Edge> of_q = edges_of(q);
  for (const Edge& e : of_p) {
    for (const Edge& f : of_q) {
      if (e.near(f, 0) && cross_properly(e, f)) return true;
    }
  }
  return runs_inside(of_p, of_q) || runs_inside(of_q, of_p) || same_ring(p, q);
}

bool nearer_than(const Polygon& p, const Polygon& q, Coord distance) {
  const std::vector<Edge> of_p = edges_of(p);
  const std::vector<Edge> of_q = edges_of(q);
  const Wide squared = product(distance, distance);
  for (const Edge& e : of_p) {
    for (const Edge& f : of_q) {
      if (!e.near(f, distance)) continue;
      // The distance of two segments that do not cross is attained at an end of one of them.
      if (cross_properly(e, f) || point_nearer(e, f.from, squared) || point_nearer(e, f.to, squared) ||
          point_nearer(f, e.from, squared) || point_nearer(f, e.to, squared)) {
        return true;
      }
    }
  }
  return interiors_share(p, q);
}

bool separable_within(const Polygon& p, const Polygon& q, Coord distance) {
  const Slides slides{p, q, distance};
  const Polygon still = in_parts(p, {});
  const Wide most = product(kParts * distance, kParts * distance);
  std::set<Vec> tried;
  const auto parts = [&](Vec t) {
    if (squared_length(t) > most || !tried.insert(t).second) return false;
    return !interiors_share(still, in_parts(q, t));
  };
  for (const auto& ways : {slides.feet(), slides.crossings()}) {
    for (const Way& way : ways) {
      for (const long double back : {0.0L, 1.0L, 4.0L, 16.0L, 64.0L, 256.0L}) {  // into acute notches as far as needed
        const Fine by = static_cast<long double>(kParts) * way.by + back * way.out;
        for (const Coord step : {Coord{1}, kParts}) {
          const Vec about{step * std::llround(by.x / static_cast<long double>(step)),
                          step * std::llround(by.y / static_cast<long double>(step))};
          for (int k = 0; k < 9; ++k) {
            if (parts({about.x + step * (k % 3 - 1), about.y + step * (k / 3 - 1)})) return true;
          }
        }
      }
    }
  }
  const auto [low_x, high_x] = extent_along(p, &Vec::x);
  const auto [low_y, high_y] = extent_along(p, &Vec::y);
  const auto [left, right] = extent_along(q, &Vec::x);
  const auto [bottom, top] = extent_along(q, &Vec::y);
  return parts({kParts * (high_x - left), 0}) || parts({kParts * (low_x - right), 0}) ||
         parts({0, kParts * (high_y - bottom)}) || parts({0, kParts * (low_y - top)});
}

bool touches_itself(const Polygon& p) {
  const std::vector<Edge> edges = edges_of(p);
  const std::size_t n = edges.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const Edge& e = edges[i];
      const Edge& f = edges[j];
      if (cross_properly(e, f) || lies_on(e, f.from) || lies_on(e, f.to) || lies_on(f, e.from) || lies_on(f, e.to)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace selvage::test
