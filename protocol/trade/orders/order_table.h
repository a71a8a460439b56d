// Orders as spreadsheets write them: tables with commas, semicolons or tabs.
//
// A table has its sizes in the columns and a row for each colour; or its sizes in the rows and a column for each
// colour, if the heading names a column of sizes or the first cells of all rows are sizes; or it is a list, whose
// heading names a column of sizes and one of quantities.  These names are known in several languages.
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "protocol/trade/orders/order.h"

namespace selvage::protocol::trade::orders {

inline constexpr double kMostGarments = 1e6;  // of one colour and size

// With its ratio.  REQUIRES: no byte order mark.
// Errors: kSyntax and kMissingField for a text that is no table, with "/line/N".
[[nodiscard]] Result<Order> read_order_table(std::string_view text);

}  // namespace selvage::protocol::trade::orders
