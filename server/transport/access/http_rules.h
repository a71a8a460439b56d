// What Host, Origin and Authorization headers say.
#pragma once

#include <string_view>

namespace selvage::server::transport::access {

// `name`, whatever its case, with a port or without.
[[nodiscard]] bool is_host(std::string_view host, std::string_view name);
// "localhost", "127.0.0.1" or "[::1]", with a port or without.
[[nodiscard]] bool is_local_host(std::string_view host);
// "http://" or "https://" and then a local host.  "null", the origin of a sandboxed page, is foreign.
[[nodiscard]] bool is_local_origin(std::string_view origin);

// Removes an authentication scheme and the blanks after it from the front; false when it is another scheme.
[[nodiscard]] bool take_scheme(std::string_view& authorization, std::string_view scheme);

}  // namespace selvage::server::transport::access
