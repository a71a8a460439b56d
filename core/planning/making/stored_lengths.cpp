#include "core/planning/making/stored_lengths.h"

#include <cmath>

#include "core/marker/figures.h"
#include "core/matching/signature.h"

namespace selvage::planning::making {
namespace {

// The sum of the differences of 24 quantiles, in widths of the strip: docs/cut-planning.md.
constexpr double kMostSpread = 0.5;

}  // namespace

Marker one_of_each_size(const Garments& garments) {
  return bundles_of(garments, orders::Ratio(garments.sizes.size(), 1));
}

std::vector<orders::MadeLength> lengths_like(const Garments& garments, std::span<const Marker> stored) {
  const matching::Signature style = matching::signature_of(one_of_each_size(garments));
  std::vector<orders::MadeLength> lengths;
  for (const Marker& marker : stored) {
    if (marker.pieces.empty() || !marker.unplaced.empty()) continue;
    const matching::Signature signature = matching::signature_of(marker);
    if (!std::isfinite(distance_between(style, signature)) || spread_between(style, signature) > kMostSpread) continue;
    const marker::Figures figures = marker::figures_of(marker);
    if (!figures.valid) continue;
    lengths.push_back({signature.area * signature.width * style.width, to_decimal(figures.length, marker.resolution)});
  }
  return lengths;
}

}  // namespace selvage::planning::making
