// What a call comes to: a result, as JSON or already as text, or an error.
#pragma once

#include <variant>

#include "protocol/rpc/json_rpc.h"
#include "server/store/kept_answers.h"

namespace selvage::server::calls {

using Outcome = std::variant<Json, store::SharedText, protocol::rpc::RpcError>;

}  // namespace selvage::server::calls
