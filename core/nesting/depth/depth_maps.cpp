#include "core/nesting/depth/depth_maps.h"

#include <array>
#include <utility>

#include "core/minkowski/sum.h"

namespace selvage::nesting::depth {
namespace {

constexpr std::size_t kSymmetries = 8;

// The frame of a map that is placed under `symmetry`; `negated`: the map is that of the opposite relative position.
constexpr MapFrame frame_of(Symmetry symmetry, bool negated) {
  const Symmetry inverse = symmetry.inverse();
  const Vec x = inverse.apply({1, 0});
  const Vec y = inverse.apply({0, 1});
  const float sign = negated ? -1.0F : 1.0F;
  return {x.x == 0, sign * static_cast<float>(x.x + y.x), sign * static_cast<float>(x.y + y.y)};
}

// By symmetry, and by whether the map is negated.
constexpr auto kFrames = [] {
  std::array<std::array<MapFrame, 2>, kSymmetries> frames{};
  for (const bool flips : {false, true}) {
    for (int quarters = 0; quarters < 4; ++quarters) {
      const Symmetry symmetry{flips, quarters};
      for (const bool negated : {false, true}) {
        frames[static_cast<std::size_t>(symmetry.index())][negated ? 1 : 0] = frame_of(symmetry, negated);
      }
    }
  }
  return frames;
}();

}  // namespace

DepthMaps::DepthMaps(const layout::PieceSet& set, MapScale scale, std::size_t limit_bytes,
                     std::function<bool()> stopped)
    : set_{set},
      scale_{scale},
      limit_{limit_bytes},
      stopped_{std::move(stopped)},
      rows_(set.outlines.size() * kSymmetries) {}

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
    if (!map) return {nothing(), kFrames[0][0]};
    bytes_ += map->bytes();
  }
  return {map.get(), kFrames[static_cast<std::size_t>(base.symmetry.index())][negated ? 1 : 0]};
}

std::unique_ptr<DepthMap> DepthMaps::make(std::uint32_t first, std::uint32_t second, Symmetry relative) const {
  const auto sum = minkowski::obstacle_sum(set_.facing(first, second), set_.facing(second, first), relative, stopped_);
  if (!sum) return nullptr;
  auto map = std::make_unique<DepthMap>(boundary_of(sum->edges(), set_.lattice_units),
                                        static_cast<float>(set_.clearance(first, second)), scale_, stopped_);
  return stopped_ && stopped_() ? nullptr : std::move(map);
}

DepthMap* DepthMaps::nothing() {
  if (!nothing_) {
    Boundary triangle;
    const float side = scale_.pixel;
    triangle.add(0, 0, side, 0);
    triangle.add(side, 0, 0, side);
    triangle.add(0, side, 0, 0);
    triangle.finish();
    nothing_ = std::make_unique<DepthMap>(std::move(triangle), 0.0F, scale_);
  }
  return nothing_.get();
}

void DepthMaps::trim() {
  if (bytes_ <= limit_) return;
  rows_ = decltype(rows_)(rows_.size());
  bytes_ = 0;
}

}  // namespace selvage::nesting::depth
