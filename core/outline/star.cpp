#include "core/outline/star.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <boost/container/static_vector.hpp>

#include "core/outline/decomposition/convex_cell.h"
#include "core/outline/decomposition/growing_kernel.h"
#include "core/outline/decomposition/triangulation.h"

namespace selvage::outline {
namespace {

// The kernel, computed by clipping the box with the line of every edge, in coordinates relative to `centre` to keep
// rounding small.
std::vector<RealVec> kernel_cell(const Polygon& polygon, const Box& box, Vec centre) {
  const auto x = [&](Coord c) { return static_cast<double>(c - centre.x); };
  const auto y = [&](Coord c) { return static_cast<double>(c - centre.y); };
  std::vector<RealVec> cell = decomposition::cell_of(box, centre);
  std::vector<RealVec> scratch;
  for (std::size_t i = 0; i < polygon.size() && !cell.empty(); ++i) {
    const Vec a = polygon[i];
    const Vec b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    decomposition::clip(cell, {x(a.x), y(a.y)}, {static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)},
                        scratch);
  }
  return cell;
}

// The smallest distance from `point` to the line of an edge; negative when the point is to the right of one.
double depth_of(RealVec point, const Polygon& polygon, Vec centre) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec a = polygon[i] - centre;
    const Vec along = polygon[i + 1 == polygon.size() ? 0 : i + 1] - polygon[i];
    const auto dx = static_cast<double>(along.x);
    const auto dy = static_cast<double>(along.y);
    const double area = dx * (point.y - static_cast<double>(a.y)) - dy * (point.x - static_cast<double>(a.x));
    least = std::min(least, area / std::hypot(dx, dy));
  }
  return least;
}

RealVec middle_of(const Polygon& polygon) {
  RealVec sum;
  for (const Vec v : polygon) {
    sum.x += static_cast<double>(v.x);
    sum.y += static_cast<double>(v.y);
  }
  const auto n = static_cast<double>(polygon.size());
  return {sum.x / n, sum.y / n};
}

// Merges triangles greedily while their union stays star-shaped.
class TriangleMerging {
 public:
  explicit TriangleMerging(const Polygon& polygon)
      : polygon_{polygon}, triangles_{decomposition::triangulate(polygon)}, kernel_{polygon} {
    find_neighbours();
    taken_.resize(triangles_.size());
    free_.resize(triangles_.size());
    std::iota(free_.begin(), free_.end(), std::size_t{0});
    std::vector<Wide> areas(triangles_.size());
    for (const std::size_t t : free_) areas[t] = doubled_area_of(t);
    std::stable_sort(free_.begin(), free_.end(), [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
  }

  std::vector<StarPart> run() {
    std::vector<StarPart> parts;
    while (!free_.empty()) {
      const Growth& growth = largest_growth();
      for (const std::size_t t : growth.members) taken_[t] = true;
      StarPart part = part_of(growth.members);
      const auto kernel = kernel_point(part.vertices);
      part.kernel = kernel ? *kernel : middle_of(part.vertices);
      parts.push_back(std::move(part));
      forget_taken();
    }
    return parts;
  }

 private:
  using Members = std::vector<std::size_t>;
  // What grows from one triangle.  It stays the same until one of the triangles that were looked at is taken.
  struct Growth {
    Members members;
    Members looked_at;
    Wide doubled_area{};
  };

  // Every triangle was cut off what was left of the polygon: its third edge is then an edge of the rest, from its first
  // vertex to its last, and the triangle lies behind that edge.
  void find_neighbours() {
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> behind(polygon_.size(), kNone);  // the edge of the rest that begins at a vertex
    next_to_.resize(triangles_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const std::size_t of_rest = t + 1 == triangles_.size() ? 3 : 2;
      for (std::size_t k = 0; k < of_rest; ++k) {
        const std::size_t other = behind[triangles_[t][k]];
        if (other == kNone) continue;
        next_to_[t].push_back(other);
        next_to_[other].push_back(t);
      }
      behind[triangles_[t].front()] = t;
    }
  }

  [[nodiscard]] Wide doubled_area_of(std::size_t t) const {
    const auto [i, j, k] = triangles_[t];
    return cross(polygon_[j] - polygon_[i], polygon_[k] - polygon_[i]);
  }

  // Of what grows from each of the few largest free triangles, the largest.
  [[nodiscard]] const Growth& largest_growth() {
    constexpr std::size_t kSeeds = 6;
    const Growth* best = nullptr;
    for (std::size_t k = 0; k < std::min(kSeeds, free_.size()); ++k) {
      const Growth& growth = growth_from(free_[k]);
      if (best == nullptr || growth.doubled_area > best->doubled_area) best = &growth;
    }
    return *best;
  }

  [[nodiscard]] const Growth& growth_from(std::size_t seed) {
    const auto [at, fresh] = growths_.try_emplace(seed);
    if (fresh) at->second = grow(seed);
    return at->second;
  }
  // Forgets the free triangles that were taken, and the growths that these change.
  void forget_taken() {
    const auto is_taken = [&](std::size_t t) { return taken_[t]; };
    std::erase_if(free_, is_taken);
    std::erase_if(growths_, [&](const auto& of_seed) {
      const Members& looked_at = of_seed.second.looked_at;
      return std::any_of(looked_at.begin(), looked_at.end(), is_taken);
    });
  }

  // Takes neighbouring triangles, breadth first, as long as the part stays star-shaped.  A triangle too thin to have a
  // kernel point is a part of its own.
  [[nodiscard]] Growth grow(std::size_t seed) {
    Growth growth{{seed}, {seed}, doubled_area_of(seed)};
    Members& members = growth.members;
    if (!kernel_point(part_of(members).vertices)) return growth;
    kernel_.start(triangles_[seed]);
    std::vector<bool> tried = taken_;
    tried[seed] = true;
    for (std::size_t m = 0; m < members.size(); ++m) {
      for (const std::size_t t : next_to_[members[m]]) {
        if (tried[t]) continue;
        tried[t] = true;
        growth.looked_at.push_back(t);
        members.push_back(t);
        if (stays_star_shaped(members, kernel_.try_triangle(triangles_[t]))) {
          kernel_.take();
          growth.doubled_area += doubled_area_of(t);
        } else {
          members.pop_back();
        }
      }
    }
    return growth;
  }
  [[nodiscard]] bool stays_star_shaped(const Members& members, decomposition::KernelVerdict verdict) const {
    if (verdict != decomposition::KernelVerdict::kUnclear) return verdict == decomposition::KernelVerdict::kDeep;
    return kernel_point(part_of(members).vertices).has_value();
  }

  // The triangles are connected along cuts, so the vertices of their union are theirs in the order of the polygon.
  [[nodiscard]] StarPart part_of(const Members& members) const {
    StarPart part;
    for (const std::size_t t : members)
      part.origin.insert(part.origin.end(), triangles_[t].begin(), triangles_[t].end());
    std::sort(part.origin.begin(), part.origin.end());
    part.origin.erase(std::unique(part.origin.begin(), part.origin.end()), part.origin.end());
    const std::size_t n = polygon_.size();
    for (const std::uint32_t i : part.origin) {
      part.vertices.push_back(polygon_[i]);
      part.turns.push_back(
          {polygon_[i] - polygon_[i == 0 ? n - 1 : i - 1], polygon_[i + 1 == n ? 0 : i + 1] - polygon_[i]});
    }
    return part;
  }

  const Polygon& polygon_;
  std::vector<decomposition::Triangle> triangles_;
  std::vector<boost::container::static_vector<std::size_t, 3>> next_to_;
  std::vector<bool> taken_;
  Members free_;                           // the triangles that are not taken, the largest first
  std::map<std::size_t, Growth> growths_;  // by seed
  decomposition::GrowingKernel kernel_;    // of the part that grows
};

}  // namespace

std::optional<RealVec> kernel_point(const Polygon& polygon) {
  const Box box = box_of(polygon);
  const Vec centre{box.low.x + box.width() / 2, box.low.y + box.height() / 2};
  const std::vector<RealVec> cell = kernel_cell(polygon, box, centre);
  if (cell.size() < 3) return std::nullopt;
  const RealVec point = decomposition::centroid(cell);
  if (depth_of(point, polygon, centre) < kKernelDepth) return std::nullopt;
  return RealVec{point.x + static_cast<double>(centre.x), point.y + static_cast<double>(centre.y)};
}

StarPart transformed(const StarPart& part, Symmetry symmetry) {
  StarPart image{transformed(part.vertices, symmetry), {}, part.origin, part.turns};
  for (Turn& turn : image.turns) turn = {symmetry.apply(turn.in), symmetry.apply(turn.out)};
  if (symmetry.flips()) {
    std::reverse(image.origin.begin() + 1, image.origin.end());
    for (Turn& turn : image.turns) turn = {-turn.out, -turn.in};
    if (!image.turns.empty()) std::reverse(image.turns.begin() + 1, image.turns.end());
  }
  double x = part.kernel.x;
  double y = symmetry.flips() ? -part.kernel.y : part.kernel.y;
  for (int k = 0; k < symmetry.quarter_turns(); ++k) {
    const double turned_x = -y;
    y = x;
    x = turned_x;
  }
  image.kernel = {x, y};
  return image;
}

std::vector<StarPart> star_parts(const Polygon& polygon) {
  if (const auto kernel = kernel_point(polygon)) {
    StarPart whole{polygon, *kernel, std::vector<std::uint32_t>(polygon.size())};
    std::iota(whole.origin.begin(), whole.origin.end(), 0U);
    return {std::move(whole)};
  }
  return TriangleMerging{polygon}.run();
}

}  // namespace selvage::outline
