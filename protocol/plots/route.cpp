#include "protocol/plots/route.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace selvage::protocol::plots {
namespace {

using document::Spot;
using Outlines = std::vector<std::vector<Spot>>;

constexpr std::size_t kMostForTwoOpt = 2000;  // stops; a sweep of 2-opt tries all pairs of them
constexpr int kMostSweeps = 20;
constexpr int kRepeats = 3;  // of 2-opt and the choice of vertices

double between(Spot a, Spot b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

class Planner {
 public:
  Planner(const Outlines& outlines, const std::vector<std::vector<std::size_t>>& before)
      : outlines_{outlines}, before_{before} {}

  Route plan() {
    nearest_neighbour();
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
      if (stops_.size() <= kMostForTwoOpt) two_opt();
      choose_vertices();
    }
    if (std::any_of(before_.begin(), before_.end(), [](const auto& list) { return !list.empty(); })) {
      move_forward();
      choose_vertices();
    }
    return {stops_, length()};
  }

 private:
  [[nodiscard]] Spot at(const RouteStop& stop) const { return outlines_[stop.piece][stop.vertex]; }
  [[nodiscard]] Spot at(std::size_t k) const { return at(stops_[k]); }
  // Before the first stop the knife is at the origin.
  [[nodiscard]] Spot before(std::size_t k) const { return k == 0 ? Spot{} : at(k - 1); }

  // The vertex of the piece that is nearest to a spot, and its distance.
  [[nodiscard]] std::pair<std::size_t, double> nearest_vertex(std::size_t piece, Spot spot) const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < outlines_[piece].size(); ++v) {
      const double away = between(outlines_[piece][v], spot);
      if (away < least) {
        least = away;
        best = v;
      }
    }
    return {best, least};
  }

  void nearest_neighbour() {
    // Sorted by their left ends, so that only pieces that may be nearer than the best one are examined.
    struct Waiting {
      std::size_t piece;
      double left;
    };
    std::vector<Waiting> waiting;
    for (std::size_t k = 0; k < outlines_.size(); ++k) {
      if (outlines_[k].empty()) continue;
      const auto left =
          std::min_element(outlines_[k].begin(), outlines_[k].end(), [](Spot a, Spot b) { return a.x < b.x; });
      waiting.push_back({k, left->x});
    }
    std::stable_sort(waiting.begin(), waiting.end(),
                     [](const Waiting& a, const Waiting& b) { return a.left < b.left; });
    Spot here;
    while (!waiting.empty()) {
      std::size_t best = 0;
      std::pair<std::size_t, double> nearest{0, std::numeric_limits<double>::infinity()};
      for (std::size_t k = 0; k < waiting.size() && waiting[k].left - here.x < nearest.second; ++k) {
        const auto found = nearest_vertex(waiting[k].piece, here);
        if (found.second >= nearest.second) continue;
        nearest = found;
        best = k;
      }
      stops_.push_back({waiting[best].piece, nearest.first});
      here = at(stops_.back());
      waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(best));
    }
  }

  // Reverses the stops from i to j where that shortens the route; the route is open at its end.
  void two_opt() {
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      bool better = false;
      for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
        for (std::size_t j = i + 1; j < stops_.size(); ++j) {
          const bool last = j + 1 == stops_.size();
          const double now = between(before(i), at(i)) + (last ? 0 : between(at(j), at(j + 1)));
          const double then = between(before(i), at(j)) + (last ? 0 : between(at(i), at(j + 1)));
          if (then >= now - 1e-9) continue;
          std::reverse(stops_.begin() + static_cast<std::ptrdiff_t>(i),
                       stops_.begin() + static_cast<std::ptrdiff_t>(j + 1));
          better = true;
        }
      }
      if (!better) return;
    }
  }

  void choose_vertices() {
    for (std::size_t k = 0; k < stops_.size(); ++k) {
      const auto& outline = outlines_[stops_[k].piece];
      const bool last = k + 1 == stops_.size();
      const auto detour = [&](std::size_t v) {
        return between(before(k), outline[v]) + (last ? 0 : between(outline[v], at(k + 1)));
      };
      for (std::size_t v = 0; v < outline.size(); ++v) {
        if (detour(v) < detour(stops_[k].vertex)) stops_[k].vertex = v;
      }
    }
  }

  // Puts what must be cut before a piece directly before it, unless it is cut earlier anyway.
  void move_forward() {
    std::vector<std::size_t> place(outlines_.size(), stops_.size());
    for (std::size_t k = 0; k < stops_.size(); ++k) place[stops_[k].piece] = k;
    std::vector<RouteStop> ordered;
    std::vector<bool> begun(stops_.size());
    const auto add = [&](const auto& self, std::size_t k) -> void {
      if (k == stops_.size() || begun[k]) return;
      begun[k] = true;
      std::vector<std::size_t> earlier;
      for (const std::size_t piece : before_[stops_[k].piece]) earlier.push_back(place[piece]);
      std::sort(earlier.begin(), earlier.end());
      for (const std::size_t one : earlier) self(self, one);
      ordered.push_back(stops_[k]);
    };
    for (std::size_t k = 0; k < stops_.size(); ++k) add(add, k);
    stops_ = std::move(ordered);
  }

  [[nodiscard]] double length() const {
    double sum = 0;
    for (std::size_t k = 0; k < stops_.size(); ++k) sum += between(before(k), at(k));
    return sum;
  }

  const Outlines& outlines_;
  const std::vector<std::vector<std::size_t>>& before_;
  std::vector<RouteStop> stops_;
};

}  // namespace

Route route_through(const Outlines& outlines, const std::vector<std::vector<std::size_t>>& before) {
  return Planner{outlines, before}.plan();
}

double travel_as_given(const Outlines& outlines) {
  double sum = 0;
  Spot here;
  for (const auto& outline : outlines) {
    if (outline.empty()) continue;
    sum += between(here, outline.front());
    here = outline.front();
  }
  return sum;
}

}  // namespace selvage::protocol::plots
