#include "protocol/trade/loops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace selvage::protocol::trade {
namespace {

using document::Spot;

// The ends of open runs, indexed by their position in a grid of squares as wide as the reach.
class Ends {
 public:
  explicit Ends(double reach) : reach_{reach}, square_{std::max(reach, 1e-9)} {}

  void add(std::size_t run, const Run& of) {
    squares_.emplace(square_of(of.points.front()), End{run, of.points.front(), true});
    squares_.emplace(square_of(of.points.back()), End{run, of.points.back(), false});
  }
  // The unused run with the lowest number that has an end within reach of the spot, and which end that is.
  [[nodiscard]] std::optional<std::pair<std::size_t, bool>> near(Spot spot, const std::vector<bool>& used) const {
    std::optional<std::pair<std::size_t, bool>> best;
    const auto [column, row] = square_of(spot);
    for (const double dx : {-1.0, 0.0, 1.0}) {
      for (const double dy : {-1.0, 0.0, 1.0}) {
        const auto [from, to] = squares_.equal_range({column + dx, row + dy});
        for (auto at = from; at != to; ++at) {
          const End& end = at->second;
          if (used[end.run] || distance(end.at, spot) > reach_) continue;
          if (!best || end.run < best->first || (end.run == best->first && end.first)) best = {end.run, end.first};
        }
      }
    }
    return best;
  }

 private:
  struct End {
    std::size_t run;
    Spot at;
    bool first;  // the first point of the run, not its last
  };
  [[nodiscard]] std::pair<double, double> square_of(Spot spot) const {
    return {std::floor(spot.x / square_), std::floor(spot.y / square_)};
  }
  double reach_, square_;
  std::multimap<std::pair<double, double>, End> squares_;
};

// The same run in the opposite direction.
void reverse(std::vector<Spot>& points, std::vector<Edge>& edges) {
  std::reverse(points.begin(), points.end());
  if (edges.empty()) return;
  // Of n points, n - 1 edges lie between; the last entry, which closes the run, stays.
  std::reverse(edges.begin(), edges.end() - 1);
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) edges[k].smooth = k + 2 < edges.size() && edges[k + 1].smooth;
}

// REQUIRES: the first point of `more` lies where the loop ends.
void append(Loop& loop, Run more) {
  if (!more.edges.empty() || !loop.edges.empty()) {
    loop.edges.resize(loop.points.size());
    more.edges.resize(more.points.size());
    loop.edges.back() = more.edges.front();
    loop.edges.insert(loop.edges.end(), more.edges.begin() + 1, more.edges.end());
  }
  loop.points.insert(loop.points.end(), more.points.begin() + 1, more.points.end());
}

}  // namespace

Loops joined(std::vector<Run> runs, double reach) {
  std::erase_if(runs, [](const Run& run) { return run.points.size() < 2; });
  std::vector<bool> used(runs.size());
  Ends ends{reach};
  const auto closes = [&](const std::vector<Spot>& points) {
    return points.size() > 2 && distance(points.front(), points.back()) <= reach;
  };
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (!runs[k].closed && !closes(runs[k].points)) ends.add(k, runs[k]);
  }
  Loops loops;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (used[k]) continue;
    used[k] = true;
    Loop loop{std::move(runs[k].points), std::move(runs[k].edges), runs[k].line, 1};
    bool reversed = false;  // a chain that cannot be continued is continued from its other end, once
    while (!runs[k].closed && !closes(loop.points)) {
      if (const auto next = ends.near(loop.points.back(), used)) {
        used[next->first] = true;
        Run& more = runs[next->first];
        if (!next->second) reverse(more.points, more.edges);
        append(loop, std::move(more));
        ++loop.runs;
      } else if (!reversed) {
        reverse(loop.points, loop.edges);
        reversed = true;
      } else {
        break;
      }
    }
    if (runs[k].closed || closes(loop.points)) {
      if (loop.points.size() > 1 && distance(loop.points.front(), loop.points.back()) <= reach) {
        loop.points.pop_back();
        if (!loop.edges.empty()) loop.edges.pop_back();
      }
      loops.closed.push_back(std::move(loop));
    } else {
      if (reversed) reverse(loop.points, loop.edges);
      loops.open.push_back({std::move(loop.points), std::move(loop.edges), false, loop.line});
    }
  }
  return loops;
}

std::vector<Spot> containing_outline(const Loop& loop) {
  if (loop.edges.empty()) return loop.points;
  const double sense = doubled_area(loop.points) < 0 ? -1 : 1;
  const std::size_t count = loop.points.size();
  const auto bulges_out = [&](std::size_t k) {
    const std::optional<Spot>& apex = loop.edges[k].apex;
    if (!apex) return false;
    const Spot a = loop.points[k], b = loop.points[(k + 1) % count];
    return sense * ((b.x - a.x) * (apex->y - a.y) - (b.y - a.y) * (apex->x - a.x)) < 0;
  };
  std::vector<Spot> outline;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t before = (k + count - 1) % count;
    // Between two tangents of one curve its point lies on the line from apex to apex.
    const bool between = loop.edges[before].smooth && bulges_out(before) && bulges_out(k);
    if (!between) outline.push_back(loop.points[k]);
    if (bulges_out(k)) outline.push_back(*loop.edges[k].apex);
  }
  return outline;
}

double doubled_area(const std::vector<Spot>& points) {
  double sum = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    // Relative to the first point, so that the area of a small piece far from the origin keeps its digits.
    const Spot a = points[k], b = points[(k + 1) % points.size()], o = points.front();
    sum += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  return sum;
}

double distance(Spot a, Spot b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

std::vector<Spot> without_repeats(const std::vector<Spot>& points, std::size_t& dropped) {
  std::vector<Spot> kept;
  kept.reserve(points.size());
  for (const Spot& point : points) {
    if (kept.empty() || point != kept.back()) kept.push_back(point);
  }
  while (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  dropped = points.size() - kept.size();
  return kept;
}

bool contains(const std::vector<Spot>& outline, Spot point) {
  if (outline.empty()) return false;
  bool inside = false;
  Spot a = outline.back();
  for (const Spot b : outline) {
    if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x))
      inside = !inside;
    a = b;
  }
  return inside;
}

namespace {

NestedLoop boxed(Loop loop) {
  NestedLoop one;
  one.low = one.high = loop.points.front();
  for (const Spot& p : loop.points) {
    one.low = {std::min(one.low.x, p.x), std::min(one.low.y, p.y)};
    one.high = {std::max(one.high.x, p.x), std::max(one.high.y, p.y)};
  }
  one.loop = std::move(loop);
  return one;
}

// Whether both are the same loop, from whichever point and in whichever direction they are drawn.
bool repeats(const NestedLoop& one, const NestedLoop& other) {
  constexpr double kSamePoint = 1e-3;
  constexpr std::size_t kLookedAt = 64;
  if (distance(one.low, other.low) > kSamePoint || distance(one.high, other.high) > kSamePoint) return false;
  const std::vector<Spot>& points = one.loop.points;
  const std::size_t count = std::min(points.size(), kLookedAt);
  for (std::size_t k = 0; k < count; ++k) {
    const Spot point = points[k * points.size() / count];
    const auto here = [&](const Spot& p) { return distance(p, point) <= kSamePoint; };
    if (std::none_of(other.loop.points.begin(), other.loop.points.end(), here)) return false;
  }
  return one.loop.points.size() == other.loop.points.size();
}

}  // namespace

std::vector<NestedLoop> nested(std::vector<Loop> loops) {
  std::erase_if(loops, [](const Loop& loop) { return !(std::abs(doubled_area(loop.points)) > 0); });
  std::stable_sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
    return std::abs(doubled_area(a.points)) > std::abs(doubled_area(b.points));
  });
  std::vector<NestedLoop> outer;
  for (Loop& loop : loops) {
    NestedLoop one = boxed(std::move(loop));
    const auto same = std::find_if(outer.begin(), outer.end(), [&](const NestedLoop& o) { return repeats(one, o); });
    if (same != outer.end()) {
      ++same->repeats;
    } else if (NestedLoop* const around = around_of(outer, one.loop.points)) {
      around->inner.push_back(std::move(one.loop));
    } else {
      outer.push_back(std::move(one));
    }
  }
  return outer;
}

NestedLoop* around_of(std::vector<NestedLoop>& outer, const std::vector<Spot>& points) {
  if (points.empty()) return nullptr;
  constexpr std::size_t kLookedAt = 64;  // a few circles of thousands of chords would take seconds
  const std::size_t count = std::min(points.size(), kLookedAt);
  const Spot first = points.front(), last = points.back(), middle = points[points.size() / 2];
  const auto found = std::find_if(outer.begin(), outer.end(), [&](const NestedLoop& one) {
    const auto in_box = [&](Spot p) {
      return p.x >= one.low.x && p.x <= one.high.x && p.y >= one.low.y && p.y <= one.high.y;
    };
    if (!in_box(first) && !in_box(last) && !in_box(middle)) return false;
    std::size_t inside = 0, outside = 0;
    while (2 * inside <= count && 2 * outside < count) {
      const Spot point = points[(inside + outside) * points.size() / count];
      ++(in_box(point) && contains(one.loop.points, point) ? inside : outside);
    }
    return 2 * inside > count;
  });
  return found == outer.end() ? nullptr : &*found;
}

}  // namespace selvage::protocol::trade
