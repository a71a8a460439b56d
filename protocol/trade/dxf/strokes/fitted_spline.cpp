#include "protocol/trade/dxf/strokes/fitted_spline.h"

#include <cmath>
#include <vector>

#include "protocol/trade/path.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::dxf::strokes {
namespace {

using document::Spot;

// The fit points, repeated ones left out; none when a coordinate is no number.
std::vector<Spot> fit_points(const Entity& spline) {
  constexpr int kX = 11, kY = 21;
  std::vector<Spot> points;
  for (const Tag& tag : spline.tags) {
    if (tag.code != kX && tag.code != kY) continue;
    const auto value = number_in(tag.text);
    if (!value || std::abs(*value) > kFarthestCoordinate) return {};
    if (tag.code == kX)
      points.push_back({*value, 0});
    else if (!points.empty())
      points.back().y = *value;
  }
  std::size_t repeated = 0;
  const bool closes = points.size() > 1 && points.front() == points.back();
  points = without_repeats(points, repeated);
  if (closes && points.size() > 1) points.push_back(points.front());  // without_repeats opens it
  return points;
}

// The direction of a tangent of the file, of length 1; none when there is no such tangent.
std::optional<Spot> tangent(const Entity& spline, int x) {
  constexpr int kToY = 10;
  const double dx = spline.number(x).value_or(0), dy = spline.number(x + kToY).value_or(0);
  const double length = std::hypot(dx, dy);
  if (!(length > 0)) return std::nullopt;
  return Spot{dx / length, dy / length};
}

// The derivatives at the points by the chord's parameter, so that second derivatives agree on both sides of each.  A
// system of three diagonals, each row of which is dominated by its middle: eliminated forwards, then substituted.
std::vector<Spot> derivatives(const std::vector<Spot>& points, std::optional<Spot> first, std::optional<Spot> last) {
  const std::size_t end = points.size() - 1;
  const auto step = [&](std::size_t k) { return distance(points[k], points[k + 1]); };
  const auto slope = [&](std::size_t k) {
    const double h = step(k);
    return Spot{(points[k + 1].x - points[k].x) / h, (points[k + 1].y - points[k].y) / h};
  };
  std::vector<double> above(points.size());
  std::vector<Spot> d(points.size());
  const auto row = [&](std::size_t k, double below, double middle, double next, Spot right) {
    const double pivot = middle - (k > 0 ? below * above[k - 1] : 0);
    const Spot before = k > 0 ? d[k - 1] : Spot{};
    above[k] = next / pivot;
    d[k] = {(right.x - below * before.x) / pivot, (right.y - below * before.y) / pivot};
  };
  const auto natural = [&](std::size_t k) { return Spot{3 * slope(k).x, 3 * slope(k).y}; };
  if (first)
    row(0, 0, 1, 0, *first);
  else
    row(0, 0, 2, 1, natural(0));
  for (std::size_t k = 1; k < end; ++k) {
    const double before = step(k - 1), after = step(k), sum = before + after;
    const Spot a = slope(k - 1), b = slope(k);
    row(k, after / sum, 2, before / sum,
        {3 * (after * a.x + before * b.x) / sum, 3 * (after * a.y + before * b.y) / sum});
  }
  if (last)
    row(end, 0, 1, 0, *last);
  else
    row(end, 1, 2, 0, natural(end - 1));
  for (std::size_t k = end; k-- > 0;) d[k] = {d[k].x - above[k] * d[k + 1].x, d[k].y - above[k] * d[k + 1].y};
  return d;
}

}  // namespace

bool is_fitted(const Entity& entity) {
  if (entity.type != "SPLINE" || !entity.vertices.empty()) return false;
  return fit_points(entity).size() > 1;
}

std::optional<Run> fitted_run(const Entity& spline, Flattening& flattening) {
  constexpr int kClosed = 1, kStartTangent = 12, kEndTangent = 13;
  // The influence of a point on a derivative falls by more than half from each point to the next: this many points of a
  // closed spline, repeated before and after it, make its ends irrelevant.
  constexpr std::size_t kBeyond = 60;
  std::vector<Spot> points = fit_points(spline);
  if (points.size() < 2) return std::nullopt;
  const bool closed = (whole_number_in(spline.text(70)).value_or(0) & kClosed) != 0 && points.size() > 2;
  if (closed && points.front() == points.back()) points.pop_back();
  const std::size_t count = points.size();
  std::vector<Spot> around = points;
  std::size_t first = 0, spans = count - 1;
  if (closed && count > 2) {
    around.clear();
    first = kBeyond;
    spans = count;
    for (std::size_t k = 0; k <= count + 2 * kBeyond; ++k)
      around.push_back(points[(k + count * kBeyond - kBeyond) % count]);
  }
  const bool periodic = spans == count;
  const auto d = derivatives(around, periodic ? std::nullopt : tangent(spline, kStartTangent),
                             periodic ? std::nullopt : tangent(spline, kEndTangent));
  Path path{around[first], flattening, spline.line};
  for (std::size_t k = first; k < first + spans; ++k) {
    const Spot a = around[k], b = around[k + 1];
    const double third = distance(a, b) / 3;
    path.cubic_to({a.x + third * d[k].x, a.y + third * d[k].y}, {b.x - third * d[k + 1].x, b.y - third * d[k + 1].y},
                  b);
  }
  return path.take(periodic);
}

}  // namespace selvage::protocol::trade::dxf::strokes
