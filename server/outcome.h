// What a call comes to: a result, as JSON or already as text, or an error.
#pragma once

#include <variant>

#include "protocol/json_rpc.h"
#include "server/kept_answers.h"

namespace selvage {

using Outcome = std::variant<Json, SharedText, RpcError>;

}  // namespace selvage
