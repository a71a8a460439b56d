#include "core/outline/triangulation.h"

#include <limits>
#include <numeric>

namespace selvage::outline {
namespace {

// The part of the polygon that has not been cut off yet, as a ring of vertex indices.
class RemainingRing {
 public:
  explicit RemainingRing(const Polygon& polygon) : polygon_{polygon}, live_(polygon.size()) {
    std::iota(live_.begin(), live_.end(), 0U);
  }
  [[nodiscard]] std::size_t size() const { return live_.size(); }
  [[nodiscard]] Triangle corner(std::size_t k) const {
    const std::size_t n = live_.size();
    return {live_[(k + n - 1) % n], live_[k], live_[(k + 1) % n]};
  }
  // True for a strictly convex corner whose closed triangle contains no other vertex.
  [[nodiscard]] bool is_ear(std::size_t k) const {
    const auto [i, j, l] = corner(k);
    const Vec a = polygon_[i];
    const Vec b = polygon_[j];
    const Vec c = polygon_[l];
    if (side_of(a, b, c) <= 0) return false;
    const std::array<Vec, 3> abc{a, b, c};
    const Box box = box_of(abc);
    for (const std::uint32_t m : live_) {
      const Vec v = polygon_[m];
      if (m == i || m == j || m == l || !box.touches({v, v})) continue;
      if (side_of(a, b, v) >= 0 && side_of(b, c, v) >= 0 && side_of(c, a, v) >= 0) return false;
    }
    return true;
  }
  // The squared length of the cut at this corner; short cuts leave remainders that are not thin.
  [[nodiscard]] double cut_length(std::size_t k) const {
    const auto [i, j, l] = corner(k);
    const Vec cut = polygon_[l] - polygon_[i];
    return static_cast<double>(dot(cut, cut));
  }
  void remove(std::size_t k) { live_.erase(live_.begin() + static_cast<std::ptrdiff_t>(k)); }

 private:
  const Polygon& polygon_;
  std::vector<std::uint32_t> live_;
};

// The ear with the shortest cut among the first few ears from `start` on: a compromise between good triangles and time.
std::size_t next_ear(const RemainingRing& ring, std::size_t start) {
  constexpr int kEnough = 8;
  std::size_t best = ring.size();
  double shortest = std::numeric_limits<double>::infinity();
  int found = 0;
  for (std::size_t step = 0; step < ring.size() && found < kEnough; ++step) {
    const std::size_t k = (start + step) % ring.size();
    if (ring.cut_length(k) >= shortest || !ring.is_ear(k)) continue;
    ++found;
    best = k;
    shortest = ring.cut_length(k);
  }
  return best;
}

}  // namespace

std::vector<Triangle> triangulate(const Polygon& polygon) {
  std::vector<Triangle> triangles;
  triangles.reserve(polygon.size());
  RemainingRing ring{polygon};
  std::size_t start = 0;
  while (ring.size() > 3) {
    const std::size_t ear = next_ear(ring, start);
    triangles.push_back(ring.corner(ear));  // a simple polygon always has an ear
    ring.remove(ear);
    start = ear % ring.size();
  }
  triangles.push_back(ring.corner(1));
  return triangles;
}

}  // namespace selvage::outline
