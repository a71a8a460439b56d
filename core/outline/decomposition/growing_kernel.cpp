#include "core/outline/decomposition/growing_kernel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/outline/decomposition/convex_cell.h"

namespace selvage::outline::decomposition {
namespace {

constexpr double kSlack = 1;  // lattice units that every half-plane is moved outwards
constexpr double kDeep =
    3;  // lattice units from every moved line: then certainly a kernel point, and not a shallow one

// How far the cell's centroid lies inside the cell.
double depth_of_centroid(const ConvexCell& cell) {
  if (cell.size() < 3) return 0;
  const RealVec centre = centroid(cell);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const RealVec a = cell[i];
    const RealVec b = cell[i + 1 == cell.size() ? 0 : i + 1];
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (length > 0) least = std::min(least, (dx * (centre.y - a.y) - dy * (centre.x - a.x)) / length);
  }
  return least;
}

}  // namespace

GrowingKernel::GrowingKernel(const Polygon& polygon)
    : polygon_{polygon},
      box_{box_of(polygon)},
      centre_{box_.low.x + box_.width() / 2, box_.low.y + box_.height() / 2} {}

void GrowingKernel::start(const Triangle& seed) {
  fixed_ = cell_of(box_.grown(static_cast<Coord>(2 * kSlack)), centre_);
  cuts_.clear();
  for (std::size_t k = 0; k < 3; ++k) {
    const Edge edge{seed[k], seed[(k + 1) % 3]};
    if (is_cut(edge)) {
      cuts_.push_back(edge);
    } else {
      clip(fixed_, edge);
    }
  }
  kernel_ = fixed_;
  for (const Edge& cut : cuts_) clip(kernel_, cut);
}

KernelVerdict GrowingKernel::try_triangle(const Triangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Edge edge{triangle[(k + 1) % 3], triangle[k]};
    const auto cut = std::find(cuts_.begin(), cuts_.end(), edge);
    if (cut == cuts_.end()) continue;
    tried_.crossed = static_cast<std::size_t>(cut - cuts_.begin());
    tried_.beyond = {Edge{triangle[(k + 1) % 3], triangle[(k + 2) % 3]}, Edge{triangle[(k + 2) % 3], triangle[k]}};
    break;
  }
  tried_.fixed = fixed_;
  tried_.kernel = kernel_;
  for (const Edge& edge : tried_.beyond) {
    clip(tried_.kernel, edge);
    if (!is_cut(edge)) clip(tried_.fixed, edge);
  }
  // The cell still obeys the cut that is crossed, so it is a part of the new kernel: often enough of it.
  if (depth_of_centroid(tried_.kernel) >= kDeep) return KernelVerdict::kDeep;
  tried_.kernel = tried_.fixed;
  for (const Edge& edge : tried_.beyond) clip(tried_.kernel, edge);
  for (std::size_t k = cuts_.size(); k > 0 && !tried_.kernel.empty(); --k) {
    if (k - 1 != tried_.crossed) clip(tried_.kernel, cuts_[k - 1]);
  }
  if (tried_.kernel.empty()) return KernelVerdict::kEmpty;
  return depth_of_centroid(tried_.kernel) >= kDeep ? KernelVerdict::kDeep : KernelVerdict::kUnclear;
}

void GrowingKernel::take() {
  fixed_.swap(tried_.fixed);
  kernel_.swap(tried_.kernel);
  cuts_.erase(cuts_.begin() + static_cast<std::ptrdiff_t>(tried_.crossed));
  std::copy_if(tried_.beyond.begin(), tried_.beyond.end(), std::back_inserter(cuts_),
               [&](const Edge& edge) { return is_cut(edge); });
}

bool GrowingKernel::is_cut(Edge edge) const {
  const std::size_t next = edge.first + 1 == polygon_.size() ? 0 : edge.first + 1;
  return edge.second != next;
}

void GrowingKernel::clip(Cell& cell, Edge edge) {
  const Vec from = polygon_[edge.first] - centre_;
  const Vec along = polygon_[edge.second] - polygon_[edge.first];
  const auto dx = static_cast<double>(along.x);
  const auto dy = static_cast<double>(along.y);
  const double shift = kSlack / std::sqrt(dx * dx + dy * dy);
  decomposition::clip(cell, {static_cast<double>(from.x) + dy * shift, static_cast<double>(from.y) - dx * shift},
                      {dx, dy}, scratch_);
}

}  // namespace selvage::outline::decomposition
