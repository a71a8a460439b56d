// The core as calls reach it.  Tests put their own functions in its place: one that waits, throws or never
// ends.
#pragma once

#include <functional>
#include <utility>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/compaction/push.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/piece/bump.h"
#include "core/search/refine.h"

namespace selvage::protocol::calls {

struct Engine {
  std::function<Result<marker::Validity>(const Marker&, SumCache&, const std::stop_token&)> check =
      [](auto&&... given) { return marker::check(std::forward<decltype(given)>(given)...); };
  std::function<Result<motion::compaction::Compaction>(const Marker&, const motion::compaction::CompactionSettings&,
                                                       const scene::Run&)>
      compact = motion::compaction::compact;
  std::function<Result<motion::compaction::Compaction>(const Marker&, const search::RefineSettings&, const scene::Run&)>
      refine = search::refine;
  std::function<Result<motion::compaction::Push>(const Marker&, std::span<const motion::compaction::Force>,
                                                 const motion::compaction::CompactionSettings&, const scene::Run&)>
      push = motion::compaction::push;
  std::function<Result<motion::piece::BumpedMarker>(const Marker&, const scene::LaidOut&, PieceId, double dx, double dy,
                                                    const scene::Run&)>
      bump = [](auto&&... given) { return motion::piece::repair_and_bump(std::forward<decltype(given)>(given)...); };
  std::function<motion::dragging::Drag(const Marker&, const scene::LaidOut&, PieceId, Vec to,
                                       motion::dragging::DragMode, const scene::Run&)>
      drag = [](auto&&... given) { return motion::dragging::drag(std::forward<decltype(given)>(given)...); };
};

}  // namespace selvage::protocol::calls
