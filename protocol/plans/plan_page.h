// A plan as a page of HTML that needs no other file: what it costs, which garments it cuts, its lays, and a picture of
// each marker.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "protocol/json/value.h"

namespace selvage::protocol::plans {

// REQUIRES: `plan` is a result of plan.cut.  Errors: those of formats::read_document, for a marker's document.
[[nodiscard]] Result<std::string> plan_page(const Json& plan, std::string_view title);

}  // namespace selvage::protocol::plans
