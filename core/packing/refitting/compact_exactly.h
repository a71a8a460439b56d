// Exact compaction of windows: the pieces of a stretch of the marker are placed anew, so that the pieces behind them
// come nearer.
//
// A window is a number of consecutive pieces, by the middle of their boxes along the strip.  The pieces before it stay;
// those behind it move to the left as one, by a little; where that makes them collide with pieces before the window,
// these join it.  Whether the window's pieces then still fit is decided exactly (contain.h), in all layouts and
// orientations.  If they do, the marker is compacted, and the search goes on.  Windows slide over the marker until none
// of them gains.  Then they slide again with more nodes for each, up to a limit; every second time they are a few
// pieces larger.
//
// Windows in front of locked pieces or groups are left out, and so are those without a piece of `among`.
//
// Laws.  As for fill_gaps, except that unplaced pieces stay unplaced.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "core/motion/repair/motion_result.h"
#include "core/packing/branching/search.h"
#include "core/packing/refitting/tuning.h"

namespace selvage::packing::refitting {

struct ExactCompactionSettings {
  std::size_t pieces{8};                        // of a window
  std::size_t most_pieces{12};                  // with those that join it; larger windows are left out
  std::uint64_t nodes{300};                     // of the search in a window at most
  std::uint64_t windows{1000};                  // at most
  std::optional<std::vector<PieceId>> among{};  // a window has one of these pieces or more; absent: any
  bool turns{true};  // the pieces of a window may take other orientations that their shapes allow
  WindowTuning tuning{};
  friend bool operator==(const ExactCompactionSettings&, const ExactCompactionSettings&) = default;
};

// A round is a window.  It converges when no window gains.
struct ExactCompaction : motion::repair::MotionResult {
  std::uint64_t windows{}, kept{};
  branching::Work work;
};

// Errors: those of compaction.
[[nodiscard]] Result<ExactCompaction> compact_exactly(const Marker& start, const ExactCompactionSettings& settings,
                                                      const scene::Run& run);

}  // namespace selvage::packing::refitting
