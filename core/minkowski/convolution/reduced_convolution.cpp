#include "core/minkowski/convolution/reduced_convolution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/geometry/pseudo_angle.h"

namespace selvage::minkowski::convolution {
namespace {

// A direction: its pseudo angle in [0, 4), and the exact vector that decides nearly equal angles.
struct Direction {
  Vec vector;
  double angle{};
};
Direction direction_of(Vec v) {
  return {v, geometry::pseudo_angle(static_cast<double>(v.x), static_cast<double>(v.y))};
}
// Negative when a precedes b counter-clockwise from the x axis within one turn, positive when it follows; 0 when both
// have the same direction.
int order_of(const Direction& a, const Direction& b) {
  constexpr double kClear = 1e-12;
  if (std::abs(a.angle - b.angle) > kClear) return a.angle < b.angle ? -1 : 1;
  const Wide turn = cross(a.vector, b.vector);
  return static_cast<int>(turn < 0) - static_cast<int>(turn > 0);
}
bool before(const Direction& a, const Direction& b) {
  return order_of(a, b) < 0;
}

// A part's edges, its convex vertices, and the order of its edges by direction.
struct Turns {
  explicit Turns(const Polygon& polygon) : edge(polygon.size()), convex(polygon.size()), by_direction(polygon.size()) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) edge[i] = direction_of(polygon[i + 1 == n ? 0 : i + 1] - polygon[i]);
    for (std::size_t i = 0; i < n; ++i) convex[i] = cross(edge[i == 0 ? n - 1 : i - 1].vector, edge[i].vector) > 0;
    std::iota(by_direction.begin(), by_direction.end(), 0U);
    std::sort(by_direction.begin(), by_direction.end(), [&](auto i, auto j) {
      const int order = order_of(edge[i], edge[j]);
      return order < 0 || (order == 0 && i < j);
    });
  }
  [[nodiscard]] const Direction& into(std::size_t i) const { return edge[i == 0 ? edge.size() - 1 : i - 1]; }

  std::vector<Direction> edge;  // edge i leaves vertex i
  std::vector<char> convex;
  std::vector<std::uint32_t> by_direction;
};

// Calls visit(edge) for every edge of `edges` whose direction lies in the turn from `in` to `out` (less than half a
// turn).  The turn includes one of its two ends: `in` when `with_in` is true, otherwise `out`.
template <class Visit>
void for_edges_in_turn(const Turns& edges, const Direction& in, const Direction& out, bool with_in, Visit visit) {
  const auto& order = edges.by_direction;
  const auto begins = std::partition_point(order.begin(), order.end(), [&](auto e) {
    return with_in ? before(edges.edge[e], in) : !before(in, edges.edge[e]);
  });
  const auto start = static_cast<std::size_t>(begins - order.begin());
  for (std::size_t step = 0; step < order.size(); ++step) {
    const std::uint32_t e = order[(start + step) % order.size()];
    const Vec d = edges.edge[e].vector;
    const Wide after_in = cross(in.vector, d);
    const Wide before_out = cross(d, out.vector);
    const bool inside = with_in ? before_out > 0 && (after_in > 0 || (after_in == 0 && dot(in.vector, d) > 0))
                                : after_in > 0 && (before_out > 0 || (before_out == 0 && dot(out.vector, d) > 0));
    if (!inside) return;
    visit(e);
  }
}

// Links each candidate to the one that continues it, using a small open-addressed hash table from start to candidate.
void link(std::vector<Candidate>& candidates, std::size_t first_size, std::size_t second_size) {
  std::size_t slots = 16;
  while (slots < 2 * candidates.size()) slots *= 2;
  std::vector<std::uint32_t> table(slots, kNoCandidate);
  const auto slot_of = [&](std::uint32_t i, std::uint32_t j) {
    return ((static_cast<std::uint64_t>(i) * second_size + j) * 0x9e3779b97f4a7c15U >> 20) & (slots - 1);
  };
  for (std::uint32_t c = 0; c < candidates.size(); ++c) {
    std::size_t s = slot_of(candidates[c].first_vertex, candidates[c].second_vertex);
    while (table[s] != kNoCandidate) s = (s + 1) & (slots - 1);
    table[s] = c;
  }
  for (Candidate& c : candidates) {
    std::uint32_t i = c.first_vertex;
    std::uint32_t j = c.second_vertex;
    if (c.edge_of_first) {
      i = i + 1 == first_size ? 0 : i + 1;
    } else {
      j = j + 1 == second_size ? 0 : j + 1;
    }
    for (std::size_t s = slot_of(i, j); table[s] != kNoCandidate; s = (s + 1) & (slots - 1)) {
      Candidate& follower = candidates[table[s]];
      if (follower.first_vertex != i || follower.second_vertex != j || follower.has_previous) continue;
      c.next = table[s];
      follower.has_previous = true;
      break;
    }
  }
}

}  // namespace

bool inside_whole(const outline::StarPart& of_vertex, std::size_t vertex, const outline::StarPart& of_edge,
                  std::size_t edge, Vec along) {
  if (!of_edge.turns.empty() && of_edge.turns[edge].out != along) return true;
  if (of_vertex.turns.empty()) return false;
  const auto& [in, out] = of_vertex.turns[vertex];
  return cross(in, out) <= 0 || cross(in, along) < 0 || cross(along, out) < 0;
}

std::vector<Candidate> reduced_convolution(const outline::StarPart& first, const outline::StarPart& second) {
  const Polygon& p = first.vertices;
  const Polygon& q = second.vertices;
  const Turns p_turns{p};
  const Turns q_turns{q};
  const double centre_x = first.kernel.x + second.kernel.x;
  const double centre_y = first.kernel.y + second.kernel.y;
  std::vector<Candidate> candidates;
  candidates.reserve(2 * (p.size() + q.size()));
  const auto add = [&](std::size_t i, std::size_t j, Vec along, bool edge_of_first) {
    Candidate c;
    c.from = p[i] + q[j];
    c.to = c.from + along;
    c.ax = static_cast<double>(c.from.x) - centre_x;
    c.ay = static_cast<double>(c.from.y) - centre_y;
    c.bx = static_cast<double>(c.to.x) - centre_x;
    c.by = static_cast<double>(c.to.y) - centre_y;
    if (!(c.ax * c.by - c.ay * c.bx > 0)) return;
    c.first_vertex = static_cast<std::uint32_t>(i);
    c.second_vertex = static_cast<std::uint32_t>(j);
    c.edge_of_first = edge_of_first;
    candidates.push_back(c);
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!p_turns.convex[i]) continue;
    for_edges_in_turn(q_turns, p_turns.into(i), p_turns.edge[i], false,
                      [&](std::uint32_t e) { add(i, e, q_turns.edge[e].vector, false); });
  }
  for (std::size_t j = 0; j < q.size(); ++j) {
    if (!q_turns.convex[j]) continue;
    for_edges_in_turn(p_turns, q_turns.into(j), q_turns.edge[j], true,
                      [&](std::uint32_t e) { add(e, j, p_turns.edge[e].vector, true); });
  }
  link(candidates, p.size(), q.size());
  return candidates;
}

}  // namespace selvage::minkowski::convolution
