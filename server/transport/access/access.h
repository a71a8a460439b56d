// Who may call: by which names, from which pages, with which token.
//
// A page of a foreign site that makes a browser call the daemon - directly, or by pointing its own name at 127.0.0.1
// (DNS rebinding) - is known by its Host and Origin headers.  It cannot know a token: where one is asked for, any Host
// will do.  Origins are always judged.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace selvage::server::transport::access {

struct Access {
  std::string token{};               // asked for on every TCP connection; empty: none is
  std::vector<std::string> hosts{};  // names, without a port, by which this server is called beside this machine's own
  std::vector<std::string> origins{};  // whose pages may call, beside this machine's own: "https://marker.example"
};

[[nodiscard]] bool host_may_be(const Access& access, std::string_view host);
[[nodiscard]] bool origin_may_be(const Access& access, std::string_view origin);

// In time that tells nothing of the token but its length.  Always true when none is asked for.
[[nodiscard]] bool token_fits(const Access& access, std::string_view token);
// The value of an Authorization header: "Bearer TOKEN".
[[nodiscard]] bool authorization_fits(const Access& access, std::string_view value);

}  // namespace selvage::server::transport::access
