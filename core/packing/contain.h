// Containment: whether given pieces fit, all at once, into the room that the others leave [Li94 8.3].
//
// All other pieces stay where they are.  The search stops at the first layout; when there is none, it proves that.
//
// Laws.  (1) A layout that is found is valid, proved in integers, unless other pieces of the marker break a rule; these
// are not looked at (defect_of_staying).  (2) `kImpossible` is proved: no layout on the lattice has the pieces inside
// the container in any of the orientations that the search may use.  (3) In a larger container, what was found does not
// become impossible.
// (4) The same input and settings give the same answer, whatever the cache holds and however many threads are used.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/motion/repair/motion_result.h"
#include "core/outline/enclosed/container.h"
#include "core/packing/bodies/on_cloth.h"
#include "core/packing/branching/search.h"

namespace selvage::packing {

using outline::enclosed::Container;

struct ContainSettings {
  branching::WorkLimits limits{};
  bool turns{true};   // pieces may take other orientations that their shapes allow
  Coord clearance{};  // the pieces keep this much more than their spacing, and from the container's border; even
  std::uint64_t overlap_moves{100};  // for each piece, of the nesting that uses overlap allowances; 0: there is none
  branching::SearchTuning tuning{.subtrees = 4, .at_once = 2, .burst = 64};
  friend bool operator==(const ContainSettings&, const ContainSettings&) = default;
};

enum class Verdict {
  kFound,       // `marker` has the pieces in the room
  kImpossible,  // they do not fit
  kUndecided,   // the work limit or a stop came first, or a fit so tight that rounding to the lattice decides, or
                // overlap allowances might make room; also with more than kMostBodies pieces, or outlines with too many
                // edges (bodies.h)
};

struct Containment : motion::repair::MotionResult {
  Verdict verdict{};
  branching::Work work;
};

// The pieces, with those of their groups, go to places inside the container and inside the strip.  Where they lie now
// does not matter, except that locked ones have to fit where they are; unplaced pieces (on_cloth.h) are among those
// that may be named.  The search does not use overlap allowances: where they might make room, and it finds no layout, a
// short nesting looks for one that uses them (with_overlaps.h); if that finds none, the verdict is `kUndecided` and the
// reason kWorkLimit.  All pieces keep their rules (core/marker/rules.h); where several pieces of a shade are to be
// placed at once, the search may miss layouts and ends undecided.  Unless they are found, `marker` is the input.
[[nodiscard]] Containment contain(const Marker& start, std::span<const PieceId> pieces, const Container& container,
                                  const ContainSettings& settings, const scene::Run& run);

// The error when pieces that stay where they are break a rule, so that no layout of the given ones makes the marker
// valid; it names them.  Errors: kMarkerOverlaps, kOutsideStrip; `field` is a JSON pointer into the marker.
[[nodiscard]] std::optional<Error> defect_of_staying(const Marker& start, std::span<const PieceId> pieces);

// The cloth up to x = `end`, between the margins at its two ends; across it the rooms of the pieces count.
[[nodiscard]] Box room_until(const Strip& strip, Coord end);

}  // namespace selvage::packing
