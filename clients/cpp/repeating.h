// Which calls may be sent again when their connection broke before the answer came.
//
// Reading twice does no harm.  A change is carried out once however often it is sent, when it carries an opId: the
// daemon keeps its answer.  Anything else (a drag lives and dies with its connection) must not be sent twice.
#pragma once

#include <string>
#include <string_view>

#include "clients/cpp/answer.h"

namespace selvage::client {

// The call takes an opId.
[[nodiscard]] bool takes_op_id(std::string_view method);
// REQUIRES: a call that takes an opId has one, or parameters that the daemon will refuse.
[[nodiscard]] bool may_repeat(std::string_view method);
// Gives the call `op_id` when it takes one and has none.
void name_operation(std::string_view method, Json& params, const std::string& op_id);

}  // namespace selvage::client
