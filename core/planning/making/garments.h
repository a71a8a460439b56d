// The garments of a style: for each size, which pieces of a marker are one bundle of it; and the bundles of a ratio as
// pieces that are still to be laid out.
//
// Units: lattice units of the style's marker, unless a name says millimetres.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "core/planning/orders/order.h"
#include "core/planning/orders/ratio.h"

namespace selvage::planning::making {

struct Garments {
  Marker style;                                 // its placements mean nothing
  std::vector<std::vector<std::size_t>> sizes;  // by size: positions in style.pieces followed by style.unplaced
};

// One garment of the size.  REQUIRES: the marker's unit is the millimetre.
[[nodiscard]] orders::Size measured(const Garments& garments, std::size_t size, std::string name);

// The bundles of the ratio, none of them placed, on the style's cloth: with the shapes that they need, no limit of
// length, and no locks in x and y.  The second bundle of a size has ids that end in " #2", and so on; the first keeps
// those of the style, if they are unique.  Shades are named in the same way, so that each holds within one bundle.
[[nodiscard]] Marker bundles_of(const Garments& garments, const orders::Ratio& ratio);

// A piece of the size that has no mirror image in its bundle, by its position in `sizes`; none when the garment may be
// cut face to face.  A piece whose shape is its own mirror image, within `slack`, needs no other.
[[nodiscard]] std::optional<std::size_t> piece_without_mirror_image(const Garments& garments, std::size_t size,
                                                                    double slack);

}  // namespace selvage::planning::making
