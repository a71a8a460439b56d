// Placing: a piece dropped anywhere goes to the nearest free position, while all others stay, as a user who drags a
// piece expects ([Li94 4.2.3] has the user drop the piece nearby and bump it).
//
// The free positions are the inner fit without the Minkowski sums with the other pieces [Li94 3.3.2].
// Laws.  (1) The position is free, proved in integers.  (2) A wanted position that is free is kept.  (3) No free
// position is nearer except by rounding to the lattice: a few units, more only in corners so narrow that they contain
// no lattice point.  (4) A piece that is matched to the cloth goes to the nearest free position that matches,
// among the PlaceTuning::repeats nearest repeats.
#pragma once

#include <optional>
#include <stop_token>

#include "core/base/result.h"
#include "core/motion/placing/tuning.h"
#include "core/motion/repair/motion_result.h"

namespace selvage::motion::placing {

struct PlaceSettings {
  bool may_grow{};  // when no position within the marker's length is free, take the nearest one beyond it, but not
                    // beyond the end of the cloth or of the lattice
  PlaceTuning tuning{};
  std::stop_token stop{};  // when a stop is requested, no position is found
};
struct Place {
  Vec at;             // free
  double distance{};  // from the wanted position, lattice units
  bool grown{};       // the marker had to become longer
};

// The free position of a piece that is nearest to `wanted`, which may be anywhere; none when there is no free position.
// The strip ends where the marker does, or where the cloth does when that has an end.  The present position of the
// piece matters only in that a fixed piece stays there and a piece locked on an axis stays on its line.  The pieces of
// its group move with it.  REQUIRES: the other pieces are valid.
[[nodiscard]] std::optional<Place> place(const scene::Scene& scene, PieceId piece, Vec wanted,
                                         const PlaceSettings& settings = {});

struct PlacedMarker : repair::MotionResult {
  // None: there is no free position, and the piece stays where it was; the reason is kLatticeEnd when the marker was to
  // grow and only the lattice has no room for it, and kCancelled when the search was stopped.
  std::optional<Place> place;
};
// The same for a marker as it comes in: small overlaps among the other pieces are repaired first
// (core/motion/repair/repair.h); the piece itself may overlap them by any depth, unless it is in a group or locked.
// REQUIRES: the piece is one of the marker's.  Errors: those of repair_overlaps.
[[nodiscard]] Result<PlacedMarker> repair_and_place(const Marker& start, PieceId piece, Vec wanted,
                                                    const PlaceSettings& settings, const scene::Run& run);

}  // namespace selvage::motion::placing
