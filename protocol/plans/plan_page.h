// A plan as one self-contained HTML page: its cost, the garments it cuts, its lays and the cloth they take, and a
// picture of each marker.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "protocol/json/value.h"

namespace selvage::protocol::plans {

// REQUIRES: `plan` is a result of plan.cut.  Errors: those of formats::read_document, when it cannot read a marker's
// document.
[[nodiscard]] Result<std::string> plan_page(const Json& plan, std::string_view title);

}  // namespace selvage::protocol::plans
