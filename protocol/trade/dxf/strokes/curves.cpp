#include "protocol/trade/dxf/strokes/curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "protocol/trade/dxf/strokes/fitted_spline.h"
#include "protocol/trade/path.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::dxf::strokes {
namespace {

using document::Spot;

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kWholeTurn = 2 * std::numbers::pi;

Spot spot_of(const DxfVertex& vertex) {
  return {vertex.x, vertex.y};
}

// The arc of a bulge from the path's end to `to`.
void add_bulge(Path& path, Spot to, double bulge) {
  const Spot from = path.end();
  const double chord = distance(from, to);
  if (bulge == 0 || chord == 0) return path.line_to(to);
  const double sweep = 4 * std::atan(bulge), radius = chord * (1 + bulge * bulge) / (4 * std::abs(bulge));
  // The centre lies on the perpendicular bisector, at this signed distance to the left of the chord.
  const double offset = chord * (1 - bulge * bulge) / (4 * bulge);
  const Spot centre{(from.x + to.x) / 2 - offset * (to.y - from.y) / chord,
                    (from.y + to.y) / 2 + offset * (to.x - from.x) / chord};
  path.arc(centre, {radius, 0}, {0, radius}, std::atan2(from.y - centre.y, from.x - centre.x), sweep);
}

Run polyline_run(const Entity& entity, Flattening& flattening) {
  Path path{spot_of(entity.vertices.front()), flattening, entity.line};
  for (std::size_t k = 1; k < entity.vertices.size(); ++k) {
    add_bulge(path, spot_of(entity.vertices[k]), entity.vertices[k - 1].bulge);
  }
  if (entity.closed && entity.vertices.back().bulge != 0) {
    add_bulge(path, spot_of(entity.vertices.front()), entity.vertices.back().bulge);
  }
  return path.take(entity.closed);
}

// The angle from `from` to `to`, counter-clockwise: more than 0, and at most a whole turn, which writers round.
double sweep_between(double from, double to) {
  constexpr double kRounding = 2e-4;
  if (std::abs(std::abs(to - from) - kWholeTurn) < kRounding) return kWholeTurn;
  const double sweep = std::fmod(to - from, kWholeTurn);
  return sweep > 0 ? sweep : sweep + kWholeTurn;
}

// CIRCLE and ARC; angles in degrees, counter-clockwise.
Run circle_run(const Entity& entity, Flattening& flattening) {
  const Spot centre = spot_of(entity.vertices.front());
  const double radius = std::abs(entity.number(40).value_or(0));
  const bool whole = entity.type == "CIRCLE";
  const double from = whole ? 0 : entity.number(50).value_or(0) * kRadians;
  const double sweep = whole ? kWholeTurn : sweep_between(from, entity.number(51).value_or(360) * kRadians);
  Path path{{centre.x + radius * std::cos(from), centre.y + radius * std::sin(from)}, flattening, entity.line};
  path.arc(centre, {radius, 0}, {0, radius}, from, sweep);
  return path.take(whole);
}

Run ellipse_run(const Entity& entity, Flattening& flattening) {
  const Spot centre = spot_of(entity.vertices.front());
  const Spot u{entity.number(11).value_or(0), entity.number(21).value_or(0)};
  const double ratio = entity.number(40).value_or(1);
  const Spot v{-u.y * ratio, u.x * ratio};
  const double from = entity.number(41).value_or(0);
  const double sweep = sweep_between(from, entity.number(42).value_or(kWholeTurn));
  const double c = std::cos(from), s = std::sin(from);
  Path path{{centre.x + u.x * c + v.x * s, centre.y + u.y * c + v.y * s}, flattening, entity.line};
  path.arc(centre, u, v, from, sweep);
  return path.take(sweep == kWholeTurn);
}

// A B-spline, rational when it has weights, as DXF writes it.
struct Spline {
  std::size_t degree{};
  std::vector<double> knots, weights;
  std::vector<Spot> controls;

  // The polar form of a span [knots[span], knots[span + 1]] at `degree` parameters, by de Boor's algorithm on
  // homogeneous coordinates.  With all of them equal it is the curve's point there; with ends of an interval only, a
  // control point of the Bezier curve that the spline is on it.
  [[nodiscard]] Spot polar(std::size_t span, std::span<const double> parameters) const {
    struct Weighted {
      double x, y, w;
    };
    std::vector<Weighted> points;
    for (std::size_t k = span - degree; k <= span; ++k) {
      const double w = weights.empty() ? 1 : weights[k];
      points.push_back({controls[k].x * w, controls[k].y * w, w});
    }
    for (std::size_t r = 1; r <= degree; ++r) {
      for (std::size_t k = degree; k >= r; --k) {
        const double low = knots[k + span - degree], high = knots[k + 1 + span - r];
        const double part = high > low ? (parameters[r - 1] - low) / (high - low) : 0;
        const auto mix = [&](double a, double b) { return a + part * (b - a); };
        points[k] = {mix(points[k - 1].x, points[k].x), mix(points[k - 1].y, points[k].y),
                     mix(points[k - 1].w, points[k].w)};
      }
    }
    const Weighted& p = points[degree];
    return {p.x / p.w, p.y / p.w};
  }
  [[nodiscard]] Spot at(double t, std::size_t span) const { return polar(span, std::vector<double>(degree, t)); }

  // True if every span is a polynomial of at most the third degree, that is, a Bezier curve that Path flattens.
  [[nodiscard]] bool is_cubic() const {
    const bool rational = std::any_of(weights.begin(), weights.end(), [&](double w) { return w != weights.front(); });
    return degree <= 3 && !rational;
  }
};

std::optional<Spline> spline_of(const Entity& entity) {
  Spline spline;
  spline.degree = static_cast<std::size_t>(std::clamp(entity.number(71).value_or(3), 1.0, 25.0));
  for (const Tag& tag : entity.tags) {
    if (tag.code != 40 && tag.code != 41) continue;
    const auto value = number_in(tag.text);
    if (!value) return std::nullopt;
    (tag.code == 40 ? spline.knots : spline.weights).push_back(*value);
  }
  for (const DxfVertex& vertex : entity.vertices) spline.controls.push_back(spot_of(vertex));
  const bool complete = spline.controls.size() > spline.degree &&
                        spline.knots.size() == spline.controls.size() + spline.degree + 1 &&
                        std::is_sorted(spline.knots.begin(), spline.knots.end()) &&
                        (spline.weights.empty() || spline.weights.size() == spline.controls.size()) &&
                        std::all_of(spline.weights.begin(), spline.weights.end(), [](double w) { return w > 0; });
  if (!complete) return std::nullopt;
  return spline;
}

// Adds a span of the spline, halved until the chord lies within the tolerance of its middle and quarter points.
void add_span(Path& path, const Spline& spline, std::size_t span, double from, double to, Flattening& flattening,
              int depth) {
  const Spot a = path.end(), b = spline.at(to, span);
  const auto off = [&](double part) {
    const Spot on = spline.at(from + part * (to - from), span);
    const double length = distance(a, b);
    if (length == 0) return distance(a, on);
    return std::abs((b.x - a.x) * (on.y - a.y) - (b.y - a.y) * (on.x - a.x)) / length;
  };
  constexpr int kDeepest = 12;
  if (flattening.exhausted()) return;
  if (depth > 0 && (depth == kDeepest || std::max({off(0.25), off(0.5), off(0.75)}) <= flattening.tolerance()))
    return path.chord_to(b);
  const double middle = (from + to) / 2;
  add_span(path, spline, span, from, middle, flattening, depth + 1);
  add_span(path, spline, span, middle, to, flattening, depth + 1);
}

// A span of a cubic spline, or of one of lower degree, as the Bezier curve that it is.
void add_cubic_span(Path& path, const Spline& spline, std::size_t span, double from, double to) {
  const auto control = [&](std::size_t later) {  // of the spline's own degree
    std::vector<double> parameters(spline.degree, from);
    std::fill_n(parameters.begin(), later, to);
    return spline.polar(span, parameters);
  };
  const Spot start = path.end(), end = control(spline.degree);
  if (spline.degree == 1) return path.line_to(end);
  if (spline.degree == 3) return path.cubic_to(control(1), control(2), end);
  const Spot middle = control(1);
  const auto raised = [&](Spot corner) {
    return Spot{corner.x + (middle.x - corner.x) * 2 / 3, corner.y + (middle.y - corner.y) * 2 / 3};
  };
  path.cubic_to(raised(start), raised(end), end);
}

std::optional<Run> spline_run(const Entity& entity, Flattening& flattening) {
  const auto spline = spline_of(entity);
  if (!spline) return std::nullopt;
  const std::size_t first = spline->degree, last = spline->controls.size();
  Path path{spline->at(spline->knots[first], first), flattening, entity.line};
  for (std::size_t span = first; span < last; ++span) {
    const double from = spline->knots[span], to = spline->knots[span + 1];
    if (to <= from) continue;
    if (spline->is_cubic()) {
      add_cubic_span(path, *spline, span, from, to);
    } else {
      add_span(path, *spline, span, from, to, flattening, 0);
    }
  }
  return path.take(false);
}

}  // namespace

std::optional<Run> run_of(const Entity& entity, Flattening& flattening) {
  if (is_fitted(entity)) return fitted_run(entity, flattening);
  if (entity.vertices.empty()) return std::nullopt;
  if (entity.type == "POLYLINE" || entity.type == "LWPOLYLINE") return polyline_run(entity, flattening);
  if (entity.type == "LINE" && entity.vertices.size() == 2) return polyline_run(entity, flattening);
  if (entity.type == "CIRCLE" || entity.type == "ARC") return circle_run(entity, flattening);
  if (entity.type == "ELLIPSE") return ellipse_run(entity, flattening);
  if (entity.type == "SPLINE") return spline_run(entity, flattening);
  return std::nullopt;
}

}  // namespace selvage::protocol::trade::dxf::strokes
