// What holds a marker's length: the contacts between its left and its right edge that carry the load, from the dual
// values of the position model [Li94 4.1.4; duals as in chapter 10].
//
// The dual value of a contact says what a unit of room there is worth: how much shorter the marker would get, to first
// order.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/overlap.h"
#include "core/marker/marker.h"
#include "core/minkowski/cache.h"
#include "core/motion/compaction/tuning.h"
#include "core/scene/run.h"

namespace selvage::motion::compaction {

enum class Edge { kLeft, kRight, kBottom, kTop };  // of the strip; bottom is y = 0

struct LoadedContact {
  PieceId first;
  std::optional<PieceId> second;  // or an edge of the strip
  Edge edge{};                    // meaningful without `second`
  double worth{};                 // length per unit of room in this contact; > 0
  RealVec at;                     // where they touch; lattice units
};
// What tilting one piece about its position would bring, its shape's tilt limit aside.
struct TiltWorth {
  PieceId piece;
  double per_degree{};  // lattice units of length per degree counter-clockwise; negative: tilt it clockwise
};

struct Hold {
  std::vector<LoadedContact> contacts;  // from left to right; the loads on the right edge add up to 1
  std::vector<TiltWorth> tilts;         // of the pieces that carry load, the most telling first
  double per_spacing{};                 // length per unit of spacing: what one unit less would bring
};

// REQUIRES: a valid marker.  A marker that is not compacted is held where it stands, all the same.
// Errors: kMarkerOverlaps, kOutsideStrip for one that is not valid; kStoppedEarly.
[[nodiscard]] Result<Hold> what_holds(const Marker& marker, const scene::Run& run,
                                      const CriticalPathTuning& tuning = {});

}  // namespace selvage::motion::compaction
