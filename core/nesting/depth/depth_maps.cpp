#include "core/nesting/depth/depth_maps.h"

#include <utility>

#include "core/minkowski/sum.h"

namespace selvage::nesting::depth {
namespace {

constexpr std::size_t kSymmetries = 8;

}  // namespace

DepthMaps::DepthMaps(const layout::PieceSet& set, MapScale scale, std::size_t limit_bytes)
    : set_{set}, scale_{scale}, limit_{limit_bytes}, rows_(set.outlines.size() * kSymmetries) {}

MapView DepthMaps::view(const layout::Turned& first, const layout::Turned& second) {
  const bool negated = first.outline > second.outline;
  const layout::Turned& base = negated ? second : first;
  const layout::Turned& other = negated ? first : second;
  const Symmetry relative = base.symmetry.inverse().after(other.symmetry);
  auto& row = rows_[base.outline * kSymmetries + static_cast<std::size_t>(relative.index())];
  if (row.empty()) {
    row.resize(set_.outlines.size());
    bytes_ += row.size() * sizeof row[0];
  }
  std::unique_ptr<DepthMap>& map = row[other.outline];
  if (!map) {
    map = make(base.outline, other.outline, relative);
    bytes_ += map->bytes();
  }
  return {map.get(), frame_of(base.symmetry, negated)};
}

std::unique_ptr<DepthMap> DepthMaps::make(std::uint32_t first, std::uint32_t second, Symmetry relative) const {
  const minkowski::MinkowskiSum sum =
      minkowski::obstacle_sum(set_.facing(first, second), set_.facing(second, first), relative);
  return std::make_unique<DepthMap>(boundary_of(sum.edges(), set_.lattice_units),
                                    static_cast<float>(set_.clearance(first, second)), scale_);
}

void DepthMaps::trim() {
  if (bytes_ <= limit_) return;
  rows_ = decltype(rows_)(rows_.size());
  bytes_ = 0;
}

}  // namespace selvage::nesting::depth
