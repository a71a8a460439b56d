// The core as calls reach it.  Tests put their own functions in its place: one that waits, throws or never
// ends.
#pragma once

#include <functional>

#include "core/marker/validity.h"
#include "core/motion/bump.h"
#include "core/motion/compact.h"
#include "core/motion/drag.h"
#include "core/motion/push.h"
#include "core/motion/refine.h"

namespace selvage {

struct Engine {
  std::function<Validity(const Marker&, SumCache&)> check = selvage::check;
  std::function<Result<Compaction>(const Marker&, const CompactionSettings&, SumCache&, std::stop_token,
                                   const Observer&)>
      compact = selvage::compact;
  std::function<Result<Compaction>(const Marker&, const RefineSettings&, SumCache&, std::stop_token, const Observer&)>
      refine = selvage::refine;
  std::function<Result<Push>(const Marker&, std::span<const Force>, const CompactionSettings&, SumCache&,
                             std::stop_token, const Observer&)>
      push = selvage::push;
  std::function<Result<BumpedMarker>(const Marker&, PieceId, double dx, double dy, SumCache&, std::stop_token,
                                     const Observer&)>
      bump = selvage::heal_and_bump;
  std::function<Drag(const Marker&, PieceId, Vec to, DragMode, SumCache&, std::stop_token, const Observer&)> drag =
      selvage::drag;
};

}  // namespace selvage
