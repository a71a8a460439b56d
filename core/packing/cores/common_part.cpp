#include "core/packing/cores/common_part.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/geometry/overlap.h"
#include "core/outline/enclosed/container.h"
#include "core/outline/set_operations.h"

namespace selvage::packing::cores {
namespace {

constexpr int kLines = 32;    // on which areas are sampled
constexpr int kHalvings = 4;  // of the steps by which a place is improved
constexpr Coord kMargin = 4;  // more than corners of intersections are rounded by; lattice units

double real(Coord coord) {
  return static_cast<double>(coord);
}

// Sets `found` to where the line at `y` crosses the polygon's edges, ascending.
void crossings(std::span<const Vec> polygon, double y, std::vector<double>& found) {
  found.clear();
  Vec from = polygon.back();
  for (const Vec to : polygon) {
    if ((real(from.y) <= y) != (real(to.y) <= y)) {
      found.push_back(real(from.x) + real(to.x - from.x) * ((y - real(from.y)) / real(to.y - from.y)));
    }
    from = to;
  }
  std::sort(found.begin(), found.end());
}

class Sampler {
 public:
  Sampler(std::span<const Vec> p, std::span<const Vec> q) : p_{p}, q_{q}, own_{box_of(p)}, other_{box_of(q)} {}

  // About how much of p is covered by q, moved by `by`.
  [[nodiscard]] double area(Vec by) {
    const double low = real(std::max(own_.low.y, other_.low.y + by.y));
    const double high = real(std::min(own_.high.y, other_.high.y + by.y));
    if (low >= high) return 0;
    const double step = (high - low) / kLines;
    double sum = 0;
    for (int line = 0; line < kLines; ++line) {
      const double y = low + (line + 0.5) * step;
      crossings(p_, y, on_p_);
      crossings(q_, y - real(by.y), on_q_);
      sum += common_length(real(by.x));
    }
    return sum * step;
  }

  [[nodiscard]] Fit best() {
    const Vec low = own_.low - other_.low;
    const Vec high = own_.high - other_.high;
    fit_ = {half(low + high), 0};
    fit_.area = area(fit_.by);
    attempt({low.x, fit_.by.y});
    attempt({high.x, fit_.by.y});
    attempt({fit_.by.x, low.y});
    attempt({fit_.by.x, high.y});
    for (Vec step = half(half(high - low)); step != Vec{} && halvings_ < kHalvings; step = half(step), ++halvings_) {
      const Vec now = fit_.by;
      for (const Vec by : {Vec{step.x, 0}, Vec{-step.x, 0}, Vec{0, step.y}, Vec{0, -step.y}}) {
        if (is_between(now + by, low, high)) attempt(now + by);
      }
    }
    return fit_;
  }

 private:
  [[nodiscard]] static Vec half(Vec v) { return {v.x / 2, v.y / 2}; }
  [[nodiscard]] static bool is_between(Vec v, Vec a, Vec b) {
    return std::min(a.x, b.x) <= v.x && v.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= v.y &&
           v.y <= std::max(a.y, b.y);
  }

  void attempt(Vec by) {
    const double found = area(by);
    if (found > fit_.area) fit_ = {by, found};
  }

  // Of the intervals between crossings of p, and of q moved by `by`.
  [[nodiscard]] double common_length(double by) const {
    double sum = 0;
    std::size_t a = 0;
    std::size_t b = 0;
    while (a + 1 < on_p_.size() && b + 1 < on_q_.size()) {
      const double low = std::max(on_p_[a], on_q_[b] + by);
      const double high = std::min(on_p_[a + 1], on_q_[b + 1] + by);
      sum += std::max(0.0, high - low);
      (on_p_[a + 1] < on_q_[b + 1] + by ? a : b) += 2;
    }
    return sum;
  }

  std::span<const Vec> p_, q_;
  Box own_, other_;
  std::vector<double> on_p_, on_q_;
  Fit fit_;
  int halvings_{};
};

// What of the box around a polygon is outside of it, and a little more.
void append_outside(const Polygon& polygon, std::vector<Polygon>& taken) {
  for (const Polygon& wall : outline::enclosed::Container{polygon}.walls) {
    for (Polygon& ring : outline::grown(wall, kMargin)) taken.push_back(std::move(ring));
  }
}

Box common_box(const Box& a, const Box& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

}  // namespace

Fit best_fit(std::span<const Vec> p, std::span<const Vec> q) {
  return Sampler{p, q}.best();
}

bool lies_within(const Polygon& inner, const Polygon& outer) {
  const Box box = box_of(inner);
  const outline::enclosed::Container container{outer};
  return container.box.contains(box) && std::ranges::none_of(container.walls, [&](const Polygon& wall) {
           return geometry::overlap({wall, box_of(wall), {}}, {inner, box, {}});
         });
}

Polygon common_part(const Polygon& p, const Polygon& q) {
  const Box box = common_box(box_of(p), box_of(q)).grown(-kMargin);
  if (box.width() <= 0 || box.height() <= 0) return {};
  std::vector<Polygon> taken;
  append_outside(p, taken);
  append_outside(q, taken);
  Polygon largest;
  for (const outline::Region& region : outline::left_over(box, taken)) {
    if (!region.holes.empty()) continue;
    if (largest.empty() || doubled_area(region.outline) > doubled_area(largest)) largest = region.outline;
  }
  const auto clean = geometry::clean_polygon(largest);
  if (!clean || clean->polygon.size() > kMostCorners || !lies_within(clean->polygon, p) ||
      !lies_within(clean->polygon, q))
    return {};
  return clean->polygon;
}

}  // namespace selvage::packing::cores
