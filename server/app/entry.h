// The first message of a connection that must show a token, a line or a WebSocket's:
//   {"jsonrpc": "2.0", "id": 1, "method": "auth", "params": {"token": "..."}}
// answered with {"authorised": true}, or with kUnauthorised and the end of the connection.
#pragma once

#include <string_view>

#include "server/transport/access/service.h"

namespace selvage::server::app {

[[nodiscard]] transport::access::Entry judge_first_message(std::string_view message,
                                                           const transport::access::Access& access);

}  // namespace selvage::server::app
