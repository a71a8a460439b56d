// The first message of a connection that must show a token, a line or a WebSocket's:
//   {"jsonrpc": "2.0", "id": 1, "method": "auth", "params": {"token": "..."}}
// answered with {"authorised": true}, or with kUnauthorised and the end of the connection.
#pragma once

#include <string_view>

#include "server/transport/service.h"

namespace selvage {

[[nodiscard]] Entry judge_first_message(std::string_view message, const Access& access);

}  // namespace selvage
