// A marker without some of its pieces, which are to be placed again.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/id.h"
#include "core/marker/marker.h"

namespace selvage::packing::refitting {

struct TakenOut {
  Marker rest;                  // the pieces that were taken out are its only unplaced ones
  std::vector<PieceId> wanted;  // these, as `contain` names them
};
// REQUIRES: the pieces are different.
[[nodiscard]] TakenOut taken_out(const Marker& marker, std::span<const std::uint32_t> pieces);

// The marker with its pieces where they are in the layout of the rest, whatever their order there.
// REQUIRES: the layout has every piece of the marker.
[[nodiscard]] Marker put_back(const Marker& marker, const Marker& layout);

// The pieces that may be taken out: in no group, and free on both axes.
[[nodiscard]] std::vector<std::uint32_t> free_pieces(const Marker& marker);

}  // namespace selvage::packing::refitting
