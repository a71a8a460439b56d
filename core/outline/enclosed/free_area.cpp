#include "core/outline/enclosed/free_area.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace selvage::outline::enclosed {
namespace {

struct Edge {
  double x1, y1, x2, y2;  // x1 < x2
  std::size_t polygon;    // 0: the region

  [[nodiscard]] double at(double x) const { return y1 + (y2 - y1) * (x - x1) / (x2 - x1); }
};

void add_edges(const Polygon& polygon, std::size_t number, std::vector<Edge>& edges) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    Vec a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    if (a.x == b.x) continue;  // no line of the sweep meets it
    if (b.x < a.x) std::swap(a, b);
    edges.push_back({static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(b.x),
                     static_cast<double>(b.y), number});
  }
}

constexpr std::size_t kMostPairs = 30'000'000, kMostCrossings = 20'000;

// The abscissas of all corners, and of the crossings of edges of different polygons; ascending.  Nothing when there are
// too many pairs of edges above each other, or too many crossings.
// REQUIRES: the edges are sorted by x1.
std::optional<std::vector<double>> abscissas(const std::vector<Edge>& edges) {
  std::vector<double> all;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& e = edges[i];
    all.push_back(e.x1);
    all.push_back(e.x2);
    for (std::size_t j = i + 1; j < edges.size() && edges[j].x1 < e.x2; ++j) {
      const Edge& f = edges[j];
      if (++pairs > kMostPairs) return std::nullopt;
      if (e.polygon == f.polygon) continue;
      const double from = f.x1, to = std::min(e.x2, f.x2);
      const double before = e.at(from) - f.at(from), after = e.at(to) - f.at(to);
      if ((before < 0) != (after < 0)) all.push_back(from + (to - from) * before / (before - after));
    }
    if (all.size() > kMostCrossings + 2 * edges.size()) return std::nullopt;
  }
  std::sort(all.begin(), all.end());
  return all;
}

// The line of the sweep, which moves to the right.
class Line {
 public:
  Line(const std::vector<Edge>& edges, std::size_t polygons) : edges_{&edges}, inside_(polygons) {}

  // The length of its part at x that lies in the region and in no hole.
  double free_length(double x) {
    while (next_ < edges_->size() && (*edges_)[next_].x1 < x) met_.push_back(next_++);
    std::erase_if(met_, [&](std::size_t edge) { return (*edges_)[edge].x2 <= x; });
    crossings_.clear();
    for (const std::size_t edge : met_) crossings_.emplace_back((*edges_)[edge].at(x), (*edges_)[edge].polygon);
    std::sort(crossings_.begin(), crossings_.end());
    std::fill(inside_.begin(), inside_.end(), false);
    std::size_t holes = 0;  // that contain the line here
    double length = 0;
    for (std::size_t k = 0; k < crossings_.size(); ++k) {
      if (k > 0 && inside_[0] && holes == 0) length += crossings_[k].first - crossings_[k - 1].first;
      const std::size_t polygon = crossings_[k].second;
      inside_[polygon] = !inside_[polygon];
      if (polygon > 0) holes = inside_[polygon] ? holes + 1 : holes - 1;
    }
    return length;
  }

 private:
  const std::vector<Edge>* edges_;
  std::size_t next_{};                                     // the first edge that it has not met
  std::vector<std::size_t> met_;                           // those that it meets
  std::vector<std::pair<double, std::size_t>> crossings_;  // with them: y, and the polygon
  std::vector<bool> inside_;                               // by polygon
};

}  // namespace

double free_area(const Polygon& region, std::span<const Polygon> holes) {
  const double whole = geometry::area_of(region);
  if (holes.empty()) return whole;
  std::vector<Edge> edges;
  add_edges(region, 0, edges);
  for (std::size_t k = 0; k < holes.size(); ++k) add_edges(holes[k], k + 1, edges);
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.x1 < b.x1; });
  const auto all = abscissas(edges);
  if (!all) return whole;
  Line line{edges, holes.size() + 1};
  double area = 0;
  for (std::size_t k = 1; k < all->size(); ++k) {
    const double from = (*all)[k - 1], to = (*all)[k];
    if (from < to) area += (to - from) * line.free_length((from + to) / 2);
  }
  return area;
}

}  // namespace selvage::outline::enclosed
