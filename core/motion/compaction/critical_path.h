// The critical path of a marker: the contacts between its left and its right edge that determine its length, from the
// dual values of the position model [Li94 4.1.4; duals as in chapter 10].
//
// Only true contacts are reported: pieces and edges that touch (CriticalPathTuning::contact).  In a marker that is not
// compacted, some or all of what will hold its length may not touch yet.
// The dual value of a contact is the length that one unit of room in this contact would save, to first order.
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
#include "core/scene/strip_edge.h"

namespace selvage::motion::compaction {

struct LoadedContact {
  PieceId first;
  std::optional<PieceId> second;  // none: an edge of the strip
  StripEdge edge{};               // meaningful without `second`
  double worth{};                 // length per unit of room in this contact; > 0
  RealVec at;                     // where they touch; lattice units
};
// What tilting one piece about its position would save, regardless of its shape's tilt limit.
struct TiltWorth {
  PieceId piece;
  double per_degree{};  // lattice units of length per degree counter-clockwise; negative: tilt it clockwise
};

// What a lock costs: the length that one unit of displacement of a locked piece, with its group, would save.  Negative:
// the opposite displacement saves it.
struct LockPrice {
  PieceId piece;
  std::optional<double> per_x, per_y;  // on the axes on which the piece is locked and carries load; one at least
};

// What one of cloth's rules (core/marker/rules.h) costs.
enum class Rule { kBelow, kAbove, kFrom, kTo, kFold, kShade, kMatchX, kMatchY };
struct RulePrice {
  Rule rule{};
  std::optional<PieceId> piece;  // whose rule it is; of a shade, its first piece; none: the strip's selvedge
  double worth{};                // length per unit by which the rule gives way; > 0
  friend bool operator==(const RulePrice&, const RulePrice&) = default;
};

struct CriticalPath {
  // From left to right; in a marker compacted to the end, the loads on the right edge add up to 1.
  std::vector<LoadedContact> contacts;
  std::vector<TiltWorth> tilts;  // of the pieces that carry load, the largest effect first
  double per_spacing{};          // the length that one unit less of spacing would save
  std::vector<LockPrice> locks;  // of the locked pieces that carry load
  std::vector<RulePrice> rules;  // of the rules that carry load, the dearest first
};

// REQUIRES: a valid marker.  It need not be compacted.
// Errors: kMarkerOverlaps, kOutsideStrip for a marker that is not valid; kStoppedEarly.
[[nodiscard]] Result<CriticalPath> critical_path(const Marker& marker, const scene::Run& run,
                                                 const CriticalPathTuning& tuning = {});

}  // namespace selvage::motion::compaction
