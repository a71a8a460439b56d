#include "core/packing/coverings/covering.h"

namespace selvage::packing::coverings {

std::vector<ConvexSet> wedges(const WedgeRing& ring) {
  std::vector<ConvexSet> sets;
  for (std::uint32_t k = 0; k < ring.size(); ++k) {
    const auto sides = ring.sides(k);
    sets.emplace_back(sides.begin(), sides.end());
  }
  return sets;
}

}  // namespace selvage::packing::coverings
