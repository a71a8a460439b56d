// The core as calls reach it.  Tests put their own functions in its place: one that waits, throws or never
// ends.
#pragma once

#include <functional>
#include <utility>

#include "core/marker/validity.h"
#include "core/motion/bump.h"
#include "core/motion/compact.h"
#include "core/motion/drag.h"
#include "core/motion/push.h"
#include "core/motion/refine.h"

namespace selvage {

struct Engine {
  std::function<Result<Validity>(const Marker&, SumCache&, const std::stop_token&)> check = [](auto&&... given) {
    return selvage::check(std::forward<decltype(given)>(given)...);
  };
  std::function<Result<Compaction>(const Marker&, const CompactionSettings&, SumCache&, std::stop_token,
                                   const Observer&)>
      compact = selvage::compact;
  std::function<Result<Compaction>(const Marker&, const RefineSettings&, SumCache&, std::stop_token, const Observer&)>
      refine = selvage::refine;
  std::function<Result<Push>(const Marker&, std::span<const Force>, const CompactionSettings&, SumCache&,
                             std::stop_token, const Observer&)>
      push = selvage::push;
  std::function<Result<BumpedMarker>(const Marker&, const LaidOut&, PieceId, double dx, double dy, SumCache&,
                                     std::stop_token, const Observer&)>
      bump = [](auto&&... given) { return heal_and_bump(std::forward<decltype(given)>(given)...); };
  std::function<Drag(const Marker&, const LaidOut&, PieceId, Vec to, DragMode, SumCache&, std::stop_token,
                     const Observer&)>
      drag = [](auto&&... given) { return selvage::drag(std::forward<decltype(given)>(given)...); };
};

}  // namespace selvage
