// How a call ended: with a result, as JSON or as text, or with an error.
#pragma once

#include <variant>

#include "protocol/rpc/json_rpc.h"
#include "server/store/kept_answers.h"

namespace selvage::server::calls {

using Outcome = std::variant<Json, store::SharedText, protocol::rpc::RpcError>;

}  // namespace selvage::server::calls
