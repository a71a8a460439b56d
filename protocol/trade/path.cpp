#include "protocol/trade/path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace selvage::protocol::trade {
namespace {

using document::Spot;

constexpr int kDeepest = 14;        // halvings of a curve
constexpr double kStraight = 1e-7;  // of the tolerance's unit: a curve as flat as this is a straight edge

Spot middle(Spot a, Spot b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

// The distance of the point from the line through a and b, positive to its left; from a, when b is the same point.
double side_distance(Spot a, Spot b, Spot point) {
  const double length = distance(a, b);
  if (length == 0) return distance(a, point);
  return ((b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x)) / length;
}

// Where the line from a through b meets the line from d through c; none when they are parallel.
std::optional<Spot> crossing(Spot a, Spot b, Spot c, Spot d) {
  const Spot u{b.x - a.x, b.y - a.y}, v{c.x - d.x, c.y - d.y};
  const double det = u.x * v.y - u.y * v.x;
  if (std::abs(det) <= 1e-12 * std::hypot(u.x, u.y) * std::hypot(v.x, v.y)) return std::nullopt;
  const double t = ((d.x - a.x) * v.y - (d.y - a.y) * v.x) / det;
  return Spot{a.x + t * u.x, a.y + t * u.y};
}

}  // namespace

Path::Path(Spot start, Flattening& flattening, std::size_t line) : flattening_{flattening} {
  run_.points.push_back(start);
  run_.line = line;
}

void Path::add(Spot to, Edge edge) {
  if (edge.apex || !run_.edges.empty()) {
    run_.edges.resize(run_.points.size());
    run_.edges.back() = edge;
    run_.edges.emplace_back();
  }
  run_.points.push_back(to);
}

void Path::line_to(Spot to) {
  add(to, {});
}

void Path::chord_to(Spot to) {
  if (flattening_.take(1)) add(to, {});
}

void Path::cubic_to(Spot first, Spot second, Spot to) {
  flatten({end(), first, second, to}, 0);
  if (!run_.edges.empty() && run_.edges.size() > 1) run_.edges[run_.edges.size() - 2].smooth = false;
}

void Path::flatten(const Cubic& cubic, int depth) {
  if (flattening_.exhausted()) return;
  const auto [a, b, c, d] = cubic;
  const double tolerance = flattening_.tolerance();
  const double first = side_distance(a, d, b), second = side_distance(a, d, c);
  const double most = std::max(std::abs(first), std::abs(second));
  // A curve on its chord's line counts as straight only if the control points lie between the chord's ends.
  const bool within = distance(a, b) + distance(c, d) <= 1.5 * distance(a, d) + kStraight;
  if (depth == kDeepest || (most <= kStraight && within)) return chord_to(d);
  if (most <= tolerance && within && first * second >= 0) {
    const Spot start = a == b ? c : b, end = c == d ? b : c;
    const auto apex = crossing(a, start, end, d);
    if (apex && std::abs(side_distance(a, d, *apex)) <= 2 * tolerance && distance(a, *apex) <= distance(a, d) &&
        distance(d, *apex) <= distance(a, d)) {
      if (flattening_.take(1)) add(d, {apex, true});
      return;
    }
  }
  const Spot ab = middle(a, b), bc = middle(b, c), cd = middle(c, d);
  const Spot abc = middle(ab, bc), bcd = middle(bc, cd), half = middle(abc, bcd);
  flatten({a, ab, abc, half}, depth + 1);
  flatten({half, bcd, cd, d}, depth + 1);
}

void Path::arc(Spot centre, Spot u, Spot v, double from, double sweep) {
  const double radius = std::max(std::hypot(u.x, u.y), std::hypot(v.x, v.y));
  const double tolerance = flattening_.tolerance();
  const double cosine = std::max(0.0, 1 - tolerance / std::max(radius, tolerance));
  const double widest = std::min(2 * std::acos(cosine), std::numbers::pi / 3);
  const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / std::max(widest, 1e-6))));
  if (!flattening_.take(static_cast<std::size_t>(chords))) return;
  const double step = sweep / chords, stretch = 1 / std::cos(step / 2);
  const auto at = [&](double t, double scale) {
    const double c = scale * std::cos(t), s = scale * std::sin(t);
    return Spot{centre.x + u.x * c + v.x * s, centre.y + u.y * c + v.y * s};
  };
  const bool whole = std::abs(sweep) >= 2 * std::numbers::pi - 1e-12;
  for (int k = 0; k < chords; ++k) {
    add(at(from + step * (k + 1), 1), {at(from + step * (k + 0.5), stretch), whole || k + 1 < chords});
  }
}

Run Path::take(bool closed) {
  run_.closed = closed;
  return std::move(run_);
}

}  // namespace selvage::protocol::trade
