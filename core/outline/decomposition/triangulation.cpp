#include "core/outline/decomposition/triangulation.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace selvage::outline::decomposition {
namespace {

// The part of the polygon that is not yet cut off, as a ring of vertex indices.
class Ring {
 public:
  explicit Ring(const Polygon& polygon) : polygon_{polygon}, vertices_(polygon.size()), size_{polygon.size()} {
    const auto n = static_cast<std::uint32_t>(size_);
    for (std::uint32_t v = 0; v < n; ++v) vertices_[v] = {v == 0 ? n - 1 : v - 1, v + 1 == n ? 0 : v + 1};
    for (std::uint32_t v = 0; v < n; ++v) {
      look_at(v);
      if (!vertices_[v].convex) reflex_.push_back(v);
    }
    std::ranges::sort(reflex_, {}, [this](std::uint32_t v) { return from_left(v); });
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint32_t next(std::uint32_t v) const { return vertices_[v].next; }
  [[nodiscard]] Triangle corner(std::uint32_t v) const { return {vertices_[v].previous, v, vertices_[v].next}; }
  // The squared length of the cut that the corner leaves: short cuts leave a compact remainder.
  [[nodiscard]] double cut_length(std::uint32_t v) const { return vertices_[v].cut_length; }

  // A strictly convex corner whose closed triangle contains no other vertex.  Of several vertices in it, the one
  // farthest from the cut is reflex, so only reflex vertices need to be tested.
  [[nodiscard]] bool is_ear(std::uint32_t v) {
    if (!vertices_[v].ear) vertices_[v].ear = vertices_[v].convex && is_empty(v);
    return vertices_[v].ear;
  }

  void remove(std::uint32_t v) {
    const auto [previous, unused, next] = corner(v);
    vertices_[previous].next = next;
    vertices_[next].previous = previous;
    --size_;
    for (const std::uint32_t neighbour : {previous, next}) {
      const bool was_convex = vertices_[neighbour].convex;
      look_at(neighbour);
      if (was_convex || !vertices_[neighbour].convex) continue;
      reflex_.erase(std::ranges::lower_bound(reflex_, from_left(neighbour), {},
                                             [this](std::uint32_t m) { return from_left(m); }));
    }
  }

 private:
  struct Vertex {
    std::uint32_t previous{}, next{};
    double cut_length{};
    bool convex{};  // strictly
    bool ear{};     // known to be one: it stays one as long as its corner does, for reflex vertices only become fewer
  };

  // True when no reflex vertex lies in the corner's triangle.
  [[nodiscard]] bool is_empty(std::uint32_t v) const {
    const auto [i, j, l] = corner(v);
    const Vec a = polygon_[i];
    const Vec b = polygon_[j];
    const Vec c = polygon_[l];
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [low, high] = std::minmax({a.y, b.y, c.y});
    const auto x_of = [this](std::uint32_t m) { return polygon_[m].x; };
    for (auto m = std::ranges::lower_bound(reflex_, left, {}, x_of); m != reflex_.end() && x_of(*m) <= right; ++m) {
      const Vec p = polygon_[*m];
      if (p.y < low || p.y > high || *m == i || *m == l) continue;
      if (side_of(a, b, p) >= 0 && side_of(b, c, p) >= 0 && side_of(c, a, p) >= 0) return false;
    }
    return true;
  }

  [[nodiscard]] std::pair<Coord, std::uint32_t> from_left(std::uint32_t v) const { return {polygon_[v].x, v}; }

  void look_at(std::uint32_t v) {
    const auto [i, j, l] = corner(v);
    const Vec cut = polygon_[l] - polygon_[i];
    vertices_[v].cut_length = static_cast<double>(dot(cut, cut));
    vertices_[v].convex = side_of(polygon_[i], polygon_[j], polygon_[l]) > 0;
    vertices_[v].ear = false;
  }

  const Polygon& polygon_;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> reflex_;  // from left to right
  std::size_t size_;
};

// The ear with the shortest cut among the first few from `start` on: a compromise between shape and time.
std::uint32_t next_ear(Ring& ring, std::uint32_t start) {
  constexpr int kEnough = 8;
  std::uint32_t best = start;
  double shortest = std::numeric_limits<double>::infinity();
  int found = 0;
  std::uint32_t v = start;
  for (std::size_t step = 0; step < ring.size() && found < kEnough; ++step, v = ring.next(v)) {
    if (ring.cut_length(v) >= shortest || !ring.is_ear(v)) continue;
    ++found;
    best = v;
    shortest = ring.cut_length(v);
  }
  return best;
}

}  // namespace

std::vector<Triangle> triangulate(const Polygon& polygon) {
  std::vector<Triangle> triangles;
  triangles.reserve(polygon.size());
  Ring ring{polygon};
  std::uint32_t at = 0;
  while (ring.size() > 3) {
    const std::uint32_t ear = next_ear(ring, at);
    triangles.push_back(ring.corner(ear));  // a simple polygon always has an ear
    ring.remove(ear);
    at = ring.next(ear);
  }
  Triangle last = ring.corner(at);
  std::sort(last.begin(), last.end());  // the vertices that are left are in the order of the polygon
  triangles.push_back(last);
  return triangles;
}

}  // namespace selvage::outline::decomposition
