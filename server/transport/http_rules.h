// Which Host and Origin a request may carry.  A page of a foreign site that makes a browser call the daemon -
// directly, or by pointing its own name at 127.0.0.1 (DNS rebinding) - is known by these two.
#pragma once

#include <string_view>

namespace selvage {

// "localhost", "127.0.0.1" or "[::1]", with a port or without.
[[nodiscard]] bool is_local_host(std::string_view host);
// "http://" or "https://" and then a local host.  "null", the origin of a sandboxed page, is foreign.
[[nodiscard]] bool is_local_origin(std::string_view origin);

}  // namespace selvage
