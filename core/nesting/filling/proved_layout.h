// From a layout that hardly overlaps to a valid marker.
#pragma once

#include <optional>

#include "core/marker/marker.h"
#include "core/motion/compaction/compact.h"
#include "core/scene/run.h"

namespace selvage::nesting::filling {

// At most so many rounds.
struct ProvingLimits {
  int separation_rounds{};
  std::optional<int> compaction_rounds{};  // nothing: as many as accuracy `standard` has
};

// The marker repaired, compacted and proved.  Where repair alone fails, it is separated first.  Nothing when that
// fails, too, or when cancelled before the marker is valid.
[[nodiscard]] std::optional<motion::compaction::Compaction> proved(const Marker& marker, const ProvingLimits& limits,
                                                                   const scene::Run& run);

}  // namespace selvage::nesting::filling
