// The answer of plan.cut: a plan in the words of the order, with the documents of its markers.
#pragma once

#include "core/planning/making/nested_markers.h"
#include "core/planning/plan.h"
#include "protocol/document/marker_file.h"
#include "protocol/methods/planning/plan_messages.h"

namespace selvage::protocol::methods::planning {

// All but `stop` and `stored`.  Documents have the attributes of the style's shapes; `documented` null: there are none.
[[nodiscard]] PlanResult plan_answer(const selvage::planning::orders::Problem& problem,
                                     const selvage::planning::Plan& plan,
                                     const selvage::planning::making::MadeMarkers& made, const MarkerFile* documented);

}  // namespace selvage::protocol::methods::planning
