#include "core/outline/outward.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace selvage::outline {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr Coord kRoundingReach = 2;  // lattice points this near to a crossing are tried as corners outside both edges

double length_of(Vec v) {
  const auto x = static_cast<double>(v.x);
  const auto y = static_cast<double>(v.y);
  return std::sqrt(x * x + y * y);
}

Box box_between(Vec a, Vec b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

double distance_to_line(Vec point, Vec from, Vec to) {
  return std::abs(static_cast<double>(cross(to - from, point - from))) / length_of(to - from);
}

double distance_to_segment(Vec point, Vec from, Vec to) {
  if (dot(point - from, to - from) <= 0) return length_of(point - from);
  if (dot(point - to, to - from) >= 0) return length_of(point - to);
  return distance_to_line(point, from, to);
}

// True when two consecutive edges fold back over each other.
bool folded(Vec from, Vec shared, Vec to) {
  return side_of(from, shared, to) == 0 && dot(shared - from, to - shared) < 0;
}

// The lattice point, outside both edges, nearest to the crossing of the line from p through a and the line from n back
// through b; nothing when the lines do not cross there or no nearby lattice point qualifies.
std::optional<Vec> crossing_outside(Vec p, Vec a, Vec b, Vec n) {
  const Wide turn = cross(a - p, n - b);
  if (turn <= 0) return std::nullopt;
  const double part = static_cast<double>(cross(b - a, n - b)) / static_cast<double>(turn);
  const double x = part * static_cast<double>(a.x - p.x);
  const double y = part * static_cast<double>(a.y - p.y);
  if (std::max(std::abs(x), std::abs(y)) >= static_cast<double>(kLatticeLimit)) return std::nullopt;
  const Vec about = a + Vec{std::llround(x), std::llround(y)};
  std::optional<Vec> best;
  double least = kNever;
  for (Coord dx = -kRoundingReach; dx <= kRoundingReach; ++dx) {
    for (Coord dy = -kRoundingReach; dy <= kRoundingReach; ++dy) {
      const Vec c = about + Vec{dx, dy};
      const bool outside_both = side_of(p, c, a) >= 0 && side_of(p, c, b) >= 0 && side_of(c, n, a) >= 0 &&
                                side_of(c, n, b) >= 0 && dot(c - a, a - p) >= 0 && dot(b - c, n - b) >= 0;
      if (!outside_both || side_of(p, c, n) <= 0) continue;
      const double away = std::hypot(static_cast<double>(c.x - a.x) - x, static_cast<double>(c.y - a.y) - y);
      if (away >= least) continue;
      least = away;
      best = c;
    }
  }
  return best;
}

// The boundary while it is simplified.
//
// Every corner has a foot: a point of the given boundary at most the tolerance away.  Between the feet of an edge's
// ends, no given vertex is farther than the tolerance from the edge's line.  Hence every point of an edge is within the
// tolerance as well: the perpendicular to the edge at that point crosses the path that leads from one end to its foot,
// along the given boundary, and from the other foot to the other end.
class Simplification {
 public:
  Simplification(const Polygon& polygon, Coord tolerance)
      : given_{polygon}, tolerance_{static_cast<double>(tolerance)}, left_{polygon.size()} {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) corners_.push_back({polygon[i], i, i, (i + n - 1) % n, (i + 1) % n});
    changes_.resize(n);
    for (std::size_t i = 0; i < n; ++i) consider(i);
  }

  Polygon run() {
    while (left_ > 3 && !possible_.empty()) {
      const auto [deviation, at] = possible_.top();
      possible_.pop();
      if (deviation != changes_[at].deviation || !stays_simple(at)) continue;
      make(at);
    }
    return polygon();
  }

 private:
  struct Corner {
    Vec at;
    // The given vertices between which the foot lies; both are the same vertex when the foot is that vertex.
    std::size_t before{}, after{};
    std::size_t previous{}, next{};
    bool gone{};
  };
  struct Foot {
    double distance{kNever};
    std::size_t before{}, after{};
  };
  // A possible change at a corner: without an apex, the corner is dropped; with one, the apex replaces the corner and
  // the next corner.
  struct Change {
    double deviation{kNever};
    std::optional<Vec> apex{};
    Foot foot{};  // the apex's
  };

  [[nodiscard]] Change change_at(std::size_t corner) const {
    const Corner& a = corners_[corner];
    const Corner& p = corners_[a.previous];
    const Corner& b = corners_[a.next];
    if (side_of(p.at, a.at, b.at) <= 0) return {deviation(p.at, p.after, b.at, b.before)};
    const Corner& n = corners_[b.next];
    if (side_of(a.at, b.at, n.at) <= 0) return {};
    const auto apex = crossing_outside(p.at, a.at, b.at, n.at);
    if (!apex) return {};
    const Foot foot = foot_of(*apex, p.after, n.before);
    if (foot.distance > tolerance_) return {};
    const double before = deviation(p.at, p.after, *apex, foot.before);
    const double after = deviation(*apex, foot.after, n.at, n.before);
    return {std::max({foot.distance, before, after}), apex, foot};
  }

  // Computes the possible change at a corner again.
  void consider(std::size_t corner) {
    changes_[corner] = change_at(corner);
    if (changes_[corner].deviation <= tolerance_) possible_.emplace(changes_[corner].deviation, corner);
  }

  // The number of given vertices from `first` to `last`; 0 when `last` is the vertex before `first`.
  [[nodiscard]] std::size_t count(std::size_t first, std::size_t last) const {
    return (last + 1 + given_.size() - first) % given_.size();
  }
  // The largest distance of the given vertices between two feet from the edge between the corners above them.
  [[nodiscard]] double deviation(Vec from, std::size_t after, Vec to, std::size_t before) const {
    double most = 0;
    for (std::size_t k = count(after, before), i = after; k > 0; --k, i = (i + 1) % given_.size()) {
      most = std::max(most, distance_to_line(given_[i], from, to));
    }
    return most;
  }
  // The point of the given boundary, from one vertex to another, nearest to `point`.
  [[nodiscard]] Foot foot_of(Vec point, std::size_t first, std::size_t last) const {
    Foot foot;
    for (std::size_t k = count(first, last), i = first; k > 1; --k) {
      const std::size_t next = (i + 1) % given_.size();
      const double distance = distance_to_segment(point, given_[i], given_[next]);
      if (distance < foot.distance) foot = {distance, i, next};
      i = next;
    }
    return foot;
  }

  // True when the edges that the change creates meet no other edge.
  [[nodiscard]] bool stays_simple(std::size_t corner) const {
    const Corner& a = corners_[corner];
    const std::optional<Vec>& apex = changes_[corner].apex;
    const std::size_t from = a.previous;
    const std::size_t to = apex ? corners_[a.next].next : a.next;
    const Vec p = corners_[from].at;
    const Vec n = corners_[to].at;
    const std::array<Vec, 3> made{p, apex.value_or(p), n};
    const Box reach = box_of(made);
    for (std::size_t k = to; k != from; k = corners_[k].next) {
      const Vec c = corners_[k].at;
      const Vec d = corners_[corners_[k].next].at;
      if (!reach.touches(box_between(c, d))) continue;
      const auto clear = [&](Vec e, Vec f) {
        if (k == to && f == n) return !folded(e, n, d);
        if (corners_[k].next == from && e == p) return !folded(c, p, f);
        return !geometry::segments_meet(c, d, e, f);
      };
      if (apex ? !clear(p, *apex) || !clear(*apex, n) : !clear(p, n)) return false;
    }
    return true;
  }

  void make(std::size_t corner) {
    const Change change = changes_[corner];
    Corner& a = corners_[corner];
    const std::size_t going = change.apex ? a.next : corner;
    if (change.apex) {
      a.at = *change.apex;
      a.before = change.foot.before;
      a.after = change.foot.after;
    }
    Corner& gone = corners_[going];
    gone.gone = true;
    corners_[gone.previous].next = gone.next;
    corners_[gone.next].previous = gone.previous;
    --left_;
    changes_[going] = {};
    // Update every change that depends on this one: a change uses the corner before it and the two after it.
    std::size_t k = gone.next;
    for (int back = 0; back < 4; ++back, k = corners_[k].previous) consider(k);
  }

  [[nodiscard]] Polygon polygon() const {
    const auto first = std::find_if(corners_.begin(), corners_.end(), [](const Corner& c) { return !c.gone; });
    Polygon left;
    auto k = static_cast<std::size_t>(first - corners_.begin());
    for (; left.size() < left_; k = corners_[k].next) left.push_back(corners_[k].at);
    return left;
  }

  const Polygon& given_;
  double tolerance_;
  std::size_t left_;  // corners
  std::vector<Corner> corners_;
  std::vector<Change> changes_;                     // by corner
  using Possible = std::pair<double, std::size_t>;  // a change's deviation and its corner
  std::priority_queue<Possible, std::vector<Possible>, std::greater<>> possible_;  // some entries are out of date
};

}  // namespace

Polygon simplified_outward(const Polygon& polygon, Coord tolerance) {
  return Simplification{polygon, tolerance}.run();
}

}  // namespace selvage::outline
