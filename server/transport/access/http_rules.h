// Rules for the values of Host, Origin and Authorization headers.
#pragma once

#include <string_view>

namespace selvage::server::transport::access {

// Returns true for `name` in upper or lower case, with or without a port.
[[nodiscard]] bool is_host(std::string_view host, std::string_view name);
// "localhost", "127.0.0.1" or "[::1]", with or without a port.
[[nodiscard]] bool is_local_host(std::string_view host);
// "http://" or "https://" followed by a local host.  "null", the origin of a sandboxed page, is not local.
[[nodiscard]] bool is_local_origin(std::string_view origin);
// "http://" or "https://" followed by exactly this host and port.
[[nodiscard]] bool is_origin_of(std::string_view origin, std::string_view host);

// Removes an authentication scheme and the blanks after it from the front.  Returns false for another scheme.
[[nodiscard]] bool take_scheme(std::string_view& authorization, std::string_view scheme);

}  // namespace selvage::server::transport::access
