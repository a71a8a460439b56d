// The depth maps of a set of pieces, made when they are first asked for and kept within a limit of bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/minkowski/cache.h"
#include "core/nesting/depth/depth_map.h"
#include "core/nesting/layout/piece_set.h"

namespace selvage::nesting::depth {

class DepthMaps {
 public:
  // REQUIRES: the set and the cache outlive the maps.
  DepthMaps(const layout::PieceSet& set, SumCache& sums, MapScale scale, std::size_t limit_bytes);

  // What a piece of the first kind is to one of the second, each in the given orientation.  The view is valid until
  // trim().
  [[nodiscard]] MapView view(const layout::Turned& first, const layout::Turned& second);
  // Drops all maps when they exceed the limit.  Called between moves, so that no view is in use.
  void trim();

  [[nodiscard]] const MapScale& scale() const { return scale_; }

 private:
  [[nodiscard]] std::unique_ptr<DepthMap> make(std::uint32_t first, std::uint32_t second, Symmetry relative) const;

  const layout::PieceSet& set_;
  SumCache& sums_;
  MapScale scale_;
  std::size_t limit_, bytes_{};
  // By base outline and relative symmetry of the other; empty rows are made when they are first needed.
  std::vector<std::vector<std::unique_ptr<DepthMap>>> rows_;
};

}  // namespace selvage::nesting::depth
