// Placing: a piece dropped anywhere goes to the nearest position that is free, everything else still: what a hand that
// drags a piece asks for, again and again [Li94 4.2.3 has the hand put the piece near by and bump it].
//
// The free positions are what the Minkowski sums with the other pieces leave of the inner fit [Li94 3.3.2].
// (1) The position is free, proved in integers.  (2) A wanted position that is free is kept.  (3) No free position is
// nearer, by more than rounding to the lattice: a few units, more only in corners so narrow that they hold no lattice
// point.
#pragma once

#include <optional>

#include "core/base/result.h"
#include "core/motion/placing/tuning.h"
#include "core/motion/repair/motion_result.h"

namespace selvage::motion::placing {

struct PlaceSettings {
  bool may_grow{};  // when no position within the marker's length is free, take the nearest beyond it; not beyond the
                    // cloth's end
  PlaceTuning tuning{};
};
struct Place {
  Vec at;             // free
  double distance{};  // from the wanted position, lattice units
  bool grown{};       // the marker had to become longer
};

// The free position of a piece that is nearest to `wanted`, which may be anywhere; nothing when there is none.
// The strip's right edge is the marker's present end, or the cloth's when it has one.  Where the piece is now does not
// matter, but that a fixed piece stays there and one locked on an axis stays on its line.  Pieces of its group go with
// it.  REQUIRES: the other pieces are valid.
[[nodiscard]] std::optional<Place> place(const scene::Scene& scene, std::uint32_t piece, Vec wanted,
                                         const PlaceSettings& settings = {});

struct PlacedMarker : repair::MotionResult {
  std::optional<Place> place;  // nothing: there is no free position, and the piece is where it was
};
// The same for a marker as it comes: small overlaps among the other pieces are healed first (core/motion/heal.h); the
// piece itself may overlap them as deeply as it likes, unless it is of a group or locked.
// REQUIRES: the piece is one of the marker's.  Errors: those of heal.
[[nodiscard]] Result<PlacedMarker> repair_and_place(const Marker& start, PieceId piece, Vec wanted,
                                                    const PlaceSettings& settings, const scene::Run& run);

}  // namespace selvage::motion::placing
