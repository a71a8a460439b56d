// Authentication by the first message of a line connection or a WebSocket:
//   {"jsonrpc": "2.0", "id": 1, "method": "auth", "params": {"token": "..."}}
// It is answered with {"authorised": true}, or with kUnauthorised, after which the connection is closed.
#pragma once

#include <string_view>

#include "server/transport/access/service.h"

namespace selvage::server::app {

[[nodiscard]] transport::access::Authentication authenticate_first_message(std::string_view message,
                                                                           const transport::access::Access& access);

}  // namespace selvage::server::app
