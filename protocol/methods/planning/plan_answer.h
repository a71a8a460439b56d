// The result of plan.cut: a plan with the names of the order's colours and sizes, and the documents of its markers.
#pragma once

#include "core/planning/making/nested_markers.h"
#include "core/planning/plan.h"
#include "protocol/document/marker_file.h"
#include "protocol/methods/planning/plan_result.h"

namespace selvage::protocol::methods::planning {

// Fills all fields but `stop` and `stored`.  The markers' documents take the attributes of their shapes from
// `documented`, the style; when it is null, the result has no documents.
[[nodiscard]] PlanResult plan_answer(const selvage::planning::orders::Problem& problem,
                                     const selvage::planning::Plan& plan,
                                     const selvage::planning::making::MadeMarkers& made, const MarkerFile* documented);

}  // namespace selvage::protocol::methods::planning
