#include "core/minkowski/convolution/convex_sum.h"

#include <algorithm>

#include "core/minkowski/convolution/reduced_convolution.h"

namespace selvage::minkowski::convolution {
namespace {

// The lowest vertex, and the leftmost of several.  Starting there, edges are ordered by the angle of their direction
// from the x axis.
std::size_t lowest(const Polygon& polygon) {
  const auto at =
      std::min_element(polygon.begin(), polygon.end(), [](Vec a, Vec b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  return static_cast<std::size_t>(at - polygon.begin());
}

bool points_up(Vec d) {
  return d.y > 0 || (d.y == 0 && d.x > 0);
}

// True when direction a does not come after direction b, counter-clockwise from the x axis.
bool no_later(Vec a, Vec b) {
  if (points_up(a) != points_up(b)) return points_up(a);
  return cross(a, b) >= 0;
}

}  // namespace

StarSum convex_sum(const outline::StarPart& first, const outline::StarPart& second) {
  const Polygon& p = first.vertices;
  const Polygon& q = second.vertices;
  StarSum sum{{first.kernel.x + second.kernel.x, first.kernel.y + second.kernel.y}, {}};
  sum.edges.reserve(p.size() + q.size());
  std::size_t i = lowest(p);
  std::size_t j = lowest(q);
  const auto after = [](std::size_t k, const Polygon& polygon) { return k + 1 == polygon.size() ? 0 : k + 1; };
  std::size_t left_p = p.size();
  std::size_t left_q = q.size();
  while (left_p + left_q > 0) {
    const Vec along_p = p[after(i, p)] - p[i];
    const Vec along_q = q[after(j, q)] - q[j];
    const Vec from = p[i] + q[j];
    if (left_q == 0 || (left_p > 0 && no_later(along_p, along_q))) {
      sum.edges.push_back({from,
                           from + along_p,
                           from,
                           from + along_p,
                           {second.origin[j], first.origin[i], false},
                           inside_whole(second, j, first, i, along_p)});
      i = after(i, p);
      --left_p;
    } else {
      sum.edges.push_back({from,
                           from + along_q,
                           from,
                           from + along_q,
                           {first.origin[i], second.origin[j], true},
                           inside_whole(first, i, second, j, along_q)});
      j = after(j, q);
      --left_q;
    }
  }
  return sum;
}

}  // namespace selvage::minkowski::convolution
