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

// As std::llround, which is a call: the nearest whole number, of two equally near ones the one farther from 0.
Coord rounded(double value) {
  const auto whole = static_cast<Coord>(value);
  const double rest = value - static_cast<double>(whole);
  return whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
}

}  // namespace

StarSum star_sum(const outline::StarPart& first, const outline::StarPart& second) {
  StarSum sum{{first.kernel.x + second.kernel.x, first.kernel.y + second.kernel.y}, {}};
  const std::vector<Candidate> candidates = reduced_convolution(first, second);
  const std::vector<Stretch> envelope = polar_envelope(candidates);
  const auto lattice_point = [&](double x, double y) {
    return Vec{rounded(sum.centre.x + x), rounded(sum.centre.y + y)};
  };
  sum.edges.reserve(envelope.size());
  const Stretch* before = nullptr;
  Vec to;
  for (const Stretch& s : envelope) {
    const Candidate& c = candidates[s.candidate];
    // Each stretch starts where the previous one ends, except for jumps along rays, which occur when a kernel has no
    // depth.
    const bool goes_on = before != nullptr && before->x1 == s.x0 && before->y1 == s.y0;
    Vec from = goes_on ? to : lattice_point(s.x0, s.y0);
    to = lattice_point(s.x1, s.y1);
    before = &s;
    if (!sum.edges.empty() && sum.edges.back().to != from) {
      const Vec last = sum.edges.back().to;
      if (same_but_for_rounding(last, from)) {
        from = last;
      } else {
        sum.edges.push_back({last, from, last, from, sum.edges.back().source, false});
      }
    }
    if (from == to) continue;
    const EdgeSource source = c.edge_of_first
                                  ? EdgeSource{second.origin[c.second_vertex], first.origin[c.first_vertex], false}
                                  : EdgeSource{first.origin[c.first_vertex], second.origin[c.second_vertex], true};
    if (!sum.edges.empty() && sum.edges.back().line_from == c.from && sum.edges.back().line_to == c.to) {
      sum.edges.back().to = to;
      continue;
    }
    const bool inner = c.edge_of_first ? inside_whole(second, c.second_vertex, first, c.first_vertex, c.to - c.from)
                                       : inside_whole(first, c.first_vertex, second, c.second_vertex, c.to - c.from);
    sum.edges.push_back({from, to, c.from, c.to, source, inner});
  }
  if (!sum.edges.empty() && sum.edges.back().to != sum.edges.front().from) {
    const Vec last = sum.edges.back().to;
    const Vec first_from = sum.edges.front().from;
    if (same_but_for_rounding(last, first_from)) {
      sum.edges.back().to = first_from;
    } else {
      sum.edges.push_back({last, first_from, last, first_from, sum.edges.back().source, false});
    }
  }
  // The envelope starts on the x axis, usually in the middle of an edge: join the two halves of that edge.
  SumEdge& front = sum.edges.front();
  if (sum.edges.size() > 1 && sum.edges.back().line_from == front.line_from &&
      sum.edges.back().line_to == front.line_to) {
    front.from = sum.edges.back().from;
    sum.edges.pop_back();
  }
  return sum;
}

}  // namespace selvage::minkowski::convolution
