// The depth maps of a set of pieces, made when they are first asked for and kept within a limit of bytes.
//
// The sums that maps are made of are not kept in the cache of sums: a search has a map for every relative orientation
// of every pair, while motions ask for few of these sums, and a sum takes three times the memory of its map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/nesting/depth/depth_map.h"
#include "core/nesting/layout/piece_set.h"

namespace selvage::nesting::depth {

class DepthMaps {
 public:
  // REQUIRES: the set outlives the maps.
  DepthMaps(const layout::PieceSet& set, MapScale scale, std::size_t limit_bytes, std::function<bool()> stopped = {});

  // What a piece of the first kind is to one of the second, each in the given orientation.  The view is valid until
  // trim().  Once `stopped`, maps that are missing are not made: they look as if the two hardly overlapped.
  [[nodiscard]] MapView view(const layout::Turned& first, const layout::Turned& second);
  // Drops all maps when they exceed the limit.  Called between moves, so that no view is in use.
  void trim();

  [[nodiscard]] const MapScale& scale() const { return scale_; }

 private:
  // Null when stopped.
  [[nodiscard]] std::unique_ptr<DepthMap> make(std::uint32_t first, std::uint32_t second, Symmetry relative) const;

  [[nodiscard]] DepthMap* nothing();

  const layout::PieceSet& set_;
  MapScale scale_;
  std::size_t limit_, bytes_{};
  std::function<bool()> stopped_;
  std::unique_ptr<DepthMap> nothing_;  // stands for maps that are not made
  // By base outline and relative symmetry of the other; empty rows are made when they are first needed.
  std::vector<std::vector<std::unique_ptr<DepthMap>>> rows_;
};

}  // namespace selvage::nesting::depth
