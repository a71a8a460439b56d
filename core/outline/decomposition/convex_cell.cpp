#include "core/outline/decomposition/convex_cell.h"

#include <algorithm>

namespace selvage::outline::decomposition {

ConvexCell cell_of(const Box& box, Vec centre) {
  const RealVec low = geometry::real(box.low - centre);
  const RealVec high = geometry::real(box.high - centre);
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

void clip(ConvexCell& cell, RealVec at, RealVec along, ConvexCell& scratch) {
  const std::size_t n = cell.size();
  const auto left_by = [&](RealVec p) { return along.x * (p.y - at.y) - along.y * (p.x - at.x); };
  const auto beyond = std::find_if(cell.begin(), cell.end(), [&](RealVec p) { return left_by(p) < 0; });
  if (beyond == cell.end()) return;
  // What comes before the last vertex on the near side stays as it is.
  const auto first = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, beyond - cell.begin())) - 1;
  scratch.assign(cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(first));
  double here = left_by(cell[first]);
  for (std::size_t i = first; i < n; ++i) {
    const RealVec a = cell[i];
    const RealVec b = cell[i + 1 == n ? 0 : i + 1];
    const double next = left_by(b);
    if (here >= 0) scratch.push_back(a);
    if ((here > 0 && next < 0) || (here < 0 && next > 0)) {
      const double t = here / (here - next);
      scratch.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    here = next;
  }
  cell.swap(scratch);
}

RealVec centroid(const ConvexCell& cell) {
  double area = 0;
  RealVec sum;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    const double ux = cell[i].x - cell[0].x;
    const double uy = cell[i].y - cell[0].y;
    const double vx = cell[i + 1].x - cell[0].x;
    const double vy = cell[i + 1].y - cell[0].y;
    const double a = ux * vy - uy * vx;
    area += a;
    sum.x += a * (ux + vx);
    sum.y += a * (uy + vy);
  }
  if (!(area > 0)) return cell[0];
  return {cell[0].x + sum.x / (3 * area), cell[0].y + sum.y / (3 * area)};
}

}  // namespace selvage::outline::decomposition
