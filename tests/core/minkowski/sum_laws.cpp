#include "tests/core/minkowski/sum_laws.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

constexpr double kRounding = 2;  // lattice units: two rounded end points, and parts so short that they are left out

RealVec along(const Segment& s, double t) {
  return {s.first.x + t * (s.second.x - s.first.x), s.first.y + t * (s.second.y - s.first.y)};
}
double length_of(const Segment& s) {
  return std::hypot(s.second.x - s.first.x, s.second.y - s.first.y);
}
Segment segment_of(const minkowski::convolution::SumEdge& e) {
  return {real(e.from), real(e.to)};
}

double distance(RealVec p, const Segment& s) {
  const double dx = s.second.x - s.first.x;
  const double dy = s.second.y - s.first.y;
  const double squared = dx * dx + dy * dy;
  const double t = squared == 0 ? 0 : std::clamp(((p.x - s.first.x) * dx + (p.y - s.first.y) * dy) / squared, 0.0, 1.0);
  const RealVec nearest = along(s, t);
  return std::hypot(p.x - nearest.x, p.y - nearest.y);
}

double nearest_of(RealVec p, const std::vector<Segment>& segments) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& s : segments) least = std::min(least, distance(p, s));
  return least;
}

// The part of segment `e`, in distances from its start, that has `other` beside it, no farther than rounding.
std::optional<std::pair<double, double>> part_beside(const Segment& e, const Segment& other) {
  const double length = length_of(e);
  const RealVec d{(e.second.x - e.first.x) / length, (e.second.y - e.first.y) / length};
  const auto along_e = [&](RealVec p) { return d.x * (p.x - e.first.x) + d.y * (p.y - e.first.y); };
  const auto off_e = [&](RealVec p) { return d.x * (p.y - e.first.y) - d.y * (p.x - e.first.x); };
  double first = 0;  // the part of `other` near the line of `e`, as a range of along()
  double last = 1;
  const double start = off_e(other.first);
  const double rise = off_e(other.second) - start;
  if (rise == 0) {
    if (std::abs(start) > kRounding) return std::nullopt;
  } else {
    const auto [low, high] = std::minmax({(-kRounding - start) / rise, (kRounding - start) / rise});
    first = std::max(first, low);
    last = std::min(last, high);
    if (first > last) return std::nullopt;
  }
  const auto [from, to] = std::minmax({along_e(along(other, first)), along_e(along(other, last))});
  if (to < 0 || from > length) return std::nullopt;
  return std::pair{std::max(from, 0.0), std::min(to, length)};
}

std::string text_of(RealVec p) {
  return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
}

constexpr double kStub =
    100;  // length of what may remain of an edge at a sharp corner, inside by a few units at its end
constexpr double kLongEnough = 1000;  // long enough to test its two sides by a sample in the middle
constexpr double kSamples[] = {0.05, 0.35, 0.5, 0.8, 0.95};

// Tests laws (2), (3), (4) and (7) on one sum.
class Boundary {
 public:
  Boundary(const minkowski::MinkowskiSum& sum, const ExactSum& exact) : sum_{sum}, exact_{exact} {
    for (const minkowski::convolution::SumEdge& e : sum.edges()) ours_.push_back(segment_of(e));
  }

  [[nodiscard]] std::string broken_law() const {
    for (std::size_t e = 0; e < ours_.size(); ++e) {
      if (auto broken = broken_by(e); !broken.empty()) return broken;
    }
    for (const Segment& s : exact_.boundary()) {
      for (const double t : kSamples) {
        if (nearest_of(along(s, t), ours_) > kRounding) return "no edge covers the boundary at " + text_of(along(s, t));
      }
    }
    return broken_length();
  }

 private:
  [[nodiscard]] std::string broken_length() const {
    double whole = 0;
    double serial = 0;
    for (std::size_t e = 0; e < ours_.size(); ++e) {
      whole += length_of(ours_[e]);
      serial += length_alone(e);
    }
    const double exact = exact_.perimeter();
    const double rounding = 1e-6 * exact + 2 * kRounding * static_cast<double>(ours_.size() + exact_.boundary().size());
    if (whole >= exact - rounding && serial <= exact + rounding) return {};
    return "the boundary is " + std::to_string(exact) + " long, the edges " + std::to_string(whole) + ", single ones " +
           std::to_string(serial);
  }

  [[nodiscard]] std::string broken_by(std::size_t e) const {
    const Segment& edge = ours_[e];
    const double length = length_of(edge);
    for (const double t : kSamples) {
      if (length > kStub && hidden(along(edge, t))) return "an edge lies inside a ring at " + text_of(along(edge, t));
    }
    for (std::size_t k = 0; k < e; ++k) {
      if (twice(sum_.edges()[e], sum_.edges()[k])) return "part of a line occurs twice at " + text_of(along(edge, 0.5));
    }
    const RealVec middle = along(edge, 0.5);
    if (length < kLongEnough || neighbour_within(10, middle, e))
      return {};  // another edge is too near to test the sides by a sample
    const double reach = 3 / length;
    const RealVec left{-(edge.second.y - edge.first.y) * reach, (edge.second.x - edge.first.x) * reach};
    if (exact_.locate({middle.x + left.x, middle.y + left.y}) != geometry::Location::kInside) {
      return "the left side of an edge is outside the sum at " + text_of(middle);
    }
    if (exact_.locate({middle.x - left.x, middle.y - left.y}) != geometry::Location::kOutside) {
      return "the right side of an edge is inside the sum at " + text_of(middle);
    }
    return {};
  }

  // True when the point lies inside a ring by more than rounding, measured from the ring's edge that faces it.
  [[nodiscard]] bool hidden(RealVec p) const {
    return std::any_of(sum_.rings().begin(), sum_.rings().end(), [&](const minkowski::convolution::StarSum& ring) {
      const auto side = [](RealVec a, RealVec b, RealVec c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      };
      return std::any_of(ring.edges.begin(), ring.edges.end(), [&](const minkowski::convolution::SumEdge& e) {
        const auto [a, b] = segment_of(e);
        return side(ring.centre, a, p) >= 0 && side(ring.centre, b, p) < 0 &&
               side(a, b, p) > 2 * kRounding * length_of({a, b});
      });
    });
  }
  // True when both edges lie on one line with one direction and share more than rounding.
  static bool twice(const minkowski::convolution::SumEdge& e, const minkowski::convolution::SumEdge& f) {
    const Vec d = e.line_to - e.line_from;
    const Vec other = f.line_to - f.line_from;
    if (cross(d, other) != 0 || cross(d, f.line_from - e.line_from) != 0 || dot(d, other) < 0) return false;
    const double length = std::hypot(static_cast<double>(d.x), static_cast<double>(d.y));
    const auto at = [&](Vec v) { return static_cast<double>(dot(d, v - e.line_from)) / length; };
    const double shared = std::min(at(e.to), at(f.to)) - std::max(at(e.from), at(f.from));
    // Where lines cross at a small angle, rounding moves the end points of the visible parts by more than a few units.
    return shared > 100 && shared > 0.5 * std::min(at(e.to) - at(e.from), at(f.to) - at(f.from));
  }
  [[nodiscard]] bool neighbour_within(double reach, RealVec p, std::size_t e) const {
    for (std::size_t k = 0; k < ours_.size(); ++k) {
      if (k != e && distance(p, ours_[k]) <= reach) return true;
    }
    return false;
  }
  // Length of the parts of edge e that no other edge runs along.
  [[nodiscard]] double length_alone(std::size_t e) const {
    const double length = length_of(ours_[e]);
    std::vector<std::pair<double, double>> shared;
    for (std::size_t k = 0; k < ours_.size(); ++k) {
      if (k == e) continue;
      if (const auto part = part_beside(ours_[e], ours_[k])) shared.push_back(*part);
    }
    std::sort(shared.begin(), shared.end());
    double alone = 0;
    double covered = 0;  // everything up to here has been looked at
    for (const auto& [from, to] : shared) {
      alone += std::max(0.0, from - covered);
      covered = std::max(covered, to);
    }
    return alone + std::max(0.0, length - covered);
  }

  const minkowski::MinkowskiSum& sum_;
  const ExactSum& exact_;
  std::vector<Segment> ours_;
};

bool near_line(Vec p, const minkowski::convolution::SumEdge& e) {
  const Vec d = e.line_to - e.line_from;
  const auto off = static_cast<double>(cross(d, p - e.line_from));
  return std::abs(off) <= 1.5 * std::hypot(static_cast<double>(d.x), static_cast<double>(d.y));
}

// Tests laws (1) to (4) and (7).
std::string difference_from(const ExactSum& exact, const minkowski::MinkowskiSum& sum) {
  const double difference = exact.difference(sum).area;
  if (difference > exact.perimeter()) {
    return "the area differs by " + std::to_string(difference / exact.perimeter()) + " units along the boundary";
  }
  return Boundary{sum, exact}.broken_law();
}

std::string with(const Summands& summands, const std::string& broken) {
  if (broken.empty()) return {};
  return broken + "; first " + test::text_of(summands.first) + "; second " + test::text_of(summands.second_image());
}

// True when the edge's line is the sum of the source's vertex and edge.
bool source_makes(const minkowski::convolution::SumEdge& e, const Summands& s) {
  const Polygon& whole = e.source.vertex_of_first ? s.second : s.first;
  const Symmetry of_edge = e.source.vertex_of_first ? s.of_second : Symmetry{};
  const Vec vertex = e.source.vertex_of_first ? s.first[e.source.vertex] : s.of_second.apply(s.second[e.source.vertex]);
  const std::size_t n = whole.size();
  const Vec next = whole[(e.source.edge + (of_edge.flips() ? n - 1 : 1)) % n];
  return e.line_from == vertex + of_edge.apply(whole[e.source.edge]) && e.line_to == vertex + of_edge.apply(next);
}

}  // namespace

std::string broken_source(const Summands& summands, const minkowski::MinkowskiSum& sum) {
  for (const minkowski::convolution::SumEdge& e : sum.edges()) {
    const std::string where = " of the edge at " + text_of(along(segment_of(e), 0.5));
    if (e.from == e.to || e.line_from == e.line_to) return with(summands, "zero length" + where);
    if (!near_line(e.from, e) || !near_line(e.to, e)) return with(summands, "an end point is off the line" + where);
    const bool short_one = length_of(segment_of(e)) < 2 * kRounding;
    if (!short_one && dot(e.line_to - e.line_from, e.to - e.from) <= 0)
      return with(summands, "the line has the wrong direction" + where);
    if (!source_makes(e, summands)) return with(summands, "the wrong source" + where);
  }
  return {};
}

std::string broken_law(const Summands& summands, const minkowski::MinkowskiSum& sum) {
  if (auto broken = broken_source(summands, sum); !broken.empty()) return broken;
  const Polygon second = summands.second_image();
  if (difference_from(ExactSum{summands.first, second, ExactSum::Method::kConvolution}, sum).empty()) return {};
  return with(summands, difference_from(ExactSum{summands.first, second, ExactSum::Method::kDecomposition}, sum));
}

}  // namespace selvage::test
