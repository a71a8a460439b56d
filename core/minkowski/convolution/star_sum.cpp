#include "core/minkowski/convolution/star_sum.h"

#include <cstdlib>

#include "core/minkowski/convolution/polar_envelope.h"
#include "core/minkowski/convolution/reduced_convolution.h"

namespace selvage::minkowski::convolution {
namespace {

// True when the two can be the same point, rounded in two ways.
bool same_but_for_rounding(Vec a, Vec b) {
  return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1;
}

// Like std::llround, but without a call: the nearest whole number, of two equally near ones the one farther from 0.
Coord rounded(double value) {
  const auto whole = static_cast<Coord>(value);
  const double rest = value - static_cast<double>(whole);
  return whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
}

// Where an edge that is to start at `from` starts, after those before it: a jump becomes an edge of its own.
Vec joined_to(std::vector<SumEdge>& edges, Vec from) {
  if (edges.empty() || edges.back().to == from) return from;
  const Vec last = edges.back().to;
  if (same_but_for_rounding(last, from)) return last;
  edges.push_back({last, from, last, from, edges.back().source, false});
  return from;
}

// The last edge ends where the first one starts.  The envelope starts on the x axis, usually in the middle of an edge:
// the two halves of that edge are joined.
void close(std::vector<SumEdge>& edges) {
  if (edges.empty()) return;
  const Vec begin = edges.front().from;
  joined_to(edges, begin);
  edges.back().to = begin;
  SumEdge& front = edges.front();
  if (edges.size() > 1 && edges.back().line_from == front.line_from && edges.back().line_to == front.line_to) {
    front.from = edges.back().from;
    edges.pop_back();
  }
}

// The edge from one point to another along a candidate.
SumEdge edge_along(const Candidate& c, Vec from, Vec to, const outline::StarPart& first,
                   const outline::StarPart& second) {
  const EdgeSource source = c.edge_of_first
                                ? EdgeSource{second.origin[c.second_vertex], first.origin[c.first_vertex], false}
                                : EdgeSource{first.origin[c.first_vertex], second.origin[c.second_vertex], true};
  const Vec along = c.to - c.from;
  const bool inner = c.edge_of_first ? inside_whole(second, c.second_vertex, first, c.first_vertex, along)
                                     : inside_whole(first, c.first_vertex, second, c.second_vertex, along);
  return {from, to, c.from, c.to, source, inner};
}

}  // namespace

std::optional<StarSum> star_sum(const TurningPart& first, const TurningPart& second,
                                const std::function<bool()>& stopped) {
  const RealVec& a = first.part.kernel;
  const RealVec& b = second.part.kernel;
  StarSum sum{{a.x + b.x, a.y + b.y}, {}};
  const auto convolution = reduced_convolution(first, second, stopped);
  if (!convolution) return {};
  const std::vector<Candidate>& candidates = *convolution;
  const auto envelope = polar_envelope(candidates, stopped);
  if (!envelope) return {};
  const auto lattice_point = [&](double x, double y) {
    return Vec{rounded(sum.centre.x + x), rounded(sum.centre.y + y)};
  };
  sum.edges.reserve(envelope->size());
  const Stretch* before = nullptr;
  Vec to;
  for (const Stretch& s : *envelope) {
    const Candidate& c = candidates[s.candidate];
    // Each stretch starts where the previous one ends, except for jumps along rays, which occur when a kernel has no
    // depth.
    const bool goes_on = before != nullptr && before->x1 == s.x0 && before->y1 == s.y0;
    const Vec from = joined_to(sum.edges, goes_on ? to : lattice_point(s.x0, s.y0));
    to = lattice_point(s.x1, s.y1);
    before = &s;
    if (from == to) continue;
    if (!sum.edges.empty() && sum.edges.back().line_from == c.from && sum.edges.back().line_to == c.to) {
      sum.edges.back().to = to;
    } else {
      sum.edges.push_back(edge_along(c, from, to, first.part, second.part));
    }
  }
  close(sum.edges);
  return sum;
}

}  // namespace selvage::minkowski::convolution
