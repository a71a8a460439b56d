// The token: its file, and authentication by the first message of a line connection or a WebSocket:
//   {"jsonrpc": "2.0", "id": 1, "method": "auth", "params": {"token": "..."}}
// It is answered with {"authorised": true}, or with kUnauthorised, after which the connection is closed.
#pragma once

#include <string>
#include <string_view>

#include "server/transport/access/service.h"

namespace selvage::server::app {

// The first line of the file.  Throws a std::runtime_error that names the option and the file if it cannot be read or
// is shorter than 16 characters.
[[nodiscard]] std::string read_token(const std::string& path);

[[nodiscard]] transport::access::Authentication authenticate_first_message(std::string_view message,
                                                                           const transport::access::Access& access);

}  // namespace selvage::server::app
