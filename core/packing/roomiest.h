// The layout of pieces in a container in which they have most room: the largest clearance that all of them can keep
// from each other, from the pieces that stay and from the container's border, beyond their spacing.
//
// A clearance is tried by a containment with wider spacings (contain.h).  What fits with a clearance fits with any
// smaller one, so bisection finds the largest.
//
// Laws.  (1) The answer is that of `contain` but for where the pieces lie: it is found, impossible or undecided when
// that is.  (2) The pieces keep `clearance`, proved in integers.  (3) None larger than `clearance_bound` is possible.
// (4) As for `contain`, the cache and threads do not matter.
#pragma once

#include <optional>

#include "core/packing/contain.h"

namespace selvage::packing {

struct RoomyContainment : Containment {
  Coord clearance{};                       // of the layout, when it is found; lattice units
  std::optional<Coord> clearance_bound{};  // the least that is proved to be impossible
};

// `settings.clearance` is where it begins; the limits hold for all searches together.  REQUIRES: at least one piece.
[[nodiscard]] RoomyContainment contain_with_most_room(const Marker& start, std::span<const PieceId> pieces,
                                                      const Container& container, const ContainSettings& settings,
                                                      const scene::Run& run);

}  // namespace selvage::packing
