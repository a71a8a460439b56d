#include "core/packing/lines/chords.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/geometry/real_plane.h"

namespace selvage::packing::lines {
namespace {

constexpr Coord kLines = 64;
constexpr double kParts = 128;  // of the room's extent
constexpr double kUnit = 1;     // more than the ends of parts are rounded by

struct Point {
  double u{}, v{};  // along the axis, and along the lines
};
using Points = std::vector<Point>;

Points points_of(const Polygon& polygon, Crossing crossing) {
  Points points;
  points.reserve(polygon.size());
  for (const Vec corner : polygon) {
    const RealVec p = geometry::real(corner);
    points.push_back(crossing == Crossing::kX ? Point{p.x, p.y} : Point{p.y, p.x});
  }
  return points;
}

double crossing_at(const Point& from, const Point& to, double u) {
  return from.v + (to.v - from.v) * ((u - from.u) / (to.u - from.u));
}

// Calls `visit(from, to)` for every edge that does not lie along a line.
template <class Visit>
void for_each_edge(const Points& points, const Visit& visit) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point& from = points[k];
    const Point& to = points[k + 1 < points.size() ? k + 1 : 0];
    if (from.u != to.u) visit(from, to);
  }
}

// The part of a polygon between neighbouring corners along the axis, where its chord changes linearly.
struct Stretch {
  double from{}, to{};
  double first{}, last{};  // the chords at its ends

  [[nodiscard]] double chord(double u) const {
    const double share = std::clamp((u - from) / (to - from), 0.0, 1.0);
    return first + share * (last - first);
  }
};

std::vector<Stretch> stretches_of(const Points& points) {
  std::vector<double> corners;
  for (const Point& p : points) corners.push_back(p.u);
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::vector<Stretch> stretches;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) stretches.push_back({corners[k], corners[k + 1]});
  for_each_edge(points, [&](const Point& from, const Point& to) {
    const double sign = from.u < to.u ? -1 : 1;
    const auto begin = std::ranges::lower_bound(corners, std::min(from.u, to.u)) - corners.begin();
    const auto end = std::ranges::lower_bound(corners, std::max(from.u, to.u)) - corners.begin();
    for (auto s = stretches.begin() + begin; s != stretches.begin() + end; ++s) {
      s->first += sign * crossing_at(from, to, s->from);
      s->last += sign * crossing_at(from, to, s->to);
    }
  });
  // In an outline that runs clockwise, all of them are negative.
  for (Stretch& stretch : stretches)
    stretch = {stretch.from, stretch.to, std::abs(stretch.first), std::abs(stretch.last)};
  return stretches;
}

// Raises `least` to the chords of a polygon, on parts counted from `low`.
void include(const Points& points, double low, double part, std::vector<double>& least) {
  const std::vector<Stretch> stretches = stretches_of(points);
  auto stretch = stretches.begin();
  for (std::size_t k = 0; k < least.size(); ++k) {
    const double from = low + static_cast<double>(k) * part - kUnit;
    const double to = from + part + 2 * kUnit;
    if (from < stretches.front().from - kUnit) continue;
    if (to > stretches.back().to + kUnit) break;
    while (stretch->to < from) ++stretch;
    double found = std::numeric_limits<double>::infinity();
    for (auto s = stretch; s != stretches.end() && s->from <= to; ++s) {
      found = std::min({found, s->chord(std::max(from, s->from)), s->chord(std::min(to, s->to))});
    }
    least[k] = std::max(least[k], found - kChordSlack);
  }
}

double most_of(const std::vector<double>& least) {
  return least.empty() ? 0 : *std::ranges::max_element(least);
}

Chords least_of(std::span<const Chords> variants) {
  Chords any = variants.front();
  for (const Chords& variant : variants) {
    any.least.resize(std::min(any.least.size(), variant.least.size()));
    for (std::size_t k = 0; k < any.least.size(); ++k) any.least[k] = std::min(any.least[k], variant.least[k]);
  }
  any.most = most_of(any.least);
  return any;
}

}  // namespace

Chords chords_of(std::span<const Polygon> figure, Crossing crossing, double part) {
  std::vector<Points> all;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Polygon& polygon : figure) {
    all.push_back(points_of(polygon, crossing));
    for (const Point& p : all.back()) {
      low = std::min(low, p.u);
      high = std::max(high, p.u);
    }
  }
  Chords chords;
  chords.least.resize(static_cast<std::size_t>((high - low) / part));
  for (const Points& points : all) include(points, low, part, chords.least);
  chords.most = most_of(chords.least);
  return chords;
}

std::vector<double> free_lengths(std::span<const double> at, double low, double high, std::span<const Polygon> polygons,
                                 Crossing crossing) {
  std::vector<std::vector<std::pair<double, double>>> covered(at.size());
  std::vector<std::vector<double>> crossings(at.size());
  for (const Polygon& polygon : polygons) {
    for_each_edge(points_of(polygon, crossing), [&](const Point& from, const Point& to) {
      auto line = static_cast<std::size_t>(std::ranges::lower_bound(at, std::min(from.u, to.u)) - at.begin());
      for (; line < at.size() && at[line] < std::max(from.u, to.u); ++line) {
        crossings[line].push_back(crossing_at(from, to, at[line]));
      }
    });
    for (std::size_t line = 0; line < at.size(); ++line) {
      std::vector<double>& found = crossings[line];
      std::sort(found.begin(), found.end());
      for (std::size_t k = 0; k + 1 < found.size(); k += 2) covered[line].emplace_back(found[k], found[k + 1]);
      found.clear();
    }
  }
  std::vector<double> lengths;
  for (auto& parts : covered) {
    std::sort(parts.begin(), parts.end());
    double reached = low;
    double free = kChordSlack + 2 * kCrossingError * static_cast<double>(parts.size());
    for (const auto& [from, to] : parts) {
      free += std::max(0.0, std::min(from, high) - reached);
      reached = std::max(reached, to);
    }
    lengths.push_back(free + std::max(0.0, high - reached));
  }
  return lengths;
}

Lines lines_across(Crossing crossing, const Box& room, std::span<const Polygon> obstacles,
                   std::span<const std::vector<std::vector<Polygon>>> figures) {
  const bool across_x = crossing == Crossing::kX;
  const Coord begin = across_x ? room.low.x : room.low.y;
  const Coord extent = across_x ? room.width() : room.height();
  Lines lines;
  lines.low = static_cast<double>(across_x ? room.low.y : room.low.x);
  for (Coord k = 0; k < kLines; ++k) {
    lines.at.push_back(static_cast<double>(begin + extent * (2 * k + 1) / (2 * kLines)) + 0.5);
  }
  lines.part = std::max(1.0, static_cast<double>(extent) / kParts);
  const double high = static_cast<double>(across_x ? room.high.y : room.high.x);
  lines.room = free_lengths(lines.at, lines.low, high, obstacles, crossing);
  for (const auto& variants : figures) {
    std::vector<Chords> all;
    for (const std::vector<Polygon>& figure : variants) all.push_back(chords_of(figure, crossing, lines.part));
    all.push_back(least_of(all));
    lines.chords.push_back(std::move(all));
  }
  return lines;
}

}  // namespace selvage::packing::lines
