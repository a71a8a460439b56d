// Decides which calls may be sent again when the connection broke before the answer arrived.
//
// Reads may be repeated.  A change with an opId may be sent again, because the daemon keeps its answer and carries it
// out once.  All other calls must not be sent twice; a drag, for example, ends with its connection.
#pragma once

#include <string>
#include <string_view>

#include "clients/cpp/answer.h"

namespace selvage::client {

// Whether the call takes an opId.
[[nodiscard]] bool takes_op_id(std::string_view method);
// REQUIRES: a call that takes an opId has one, or has parameters that the daemon rejects.
[[nodiscard]] bool may_resend(std::string_view method);
// Adds `op_id` to the parameters if the method takes an opId and they have none.
void add_op_id(std::string_view method, Json& params, const std::string& op_id);

}  // namespace selvage::client
