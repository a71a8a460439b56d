// Decides who may call: under which host names, from which origins, and with which token.
//
// A page of a foreign site can make a browser call the daemon, directly or by pointing its own name at 127.0.0.1 (DNS
// rebinding).  The Host and Origin headers reveal this.  Such a page does not know the token, so with a token the Host
// header is not checked.  The Origin header is always checked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace selvage::server::transport::access {

struct Access {
  std::string token{};                 // required on every TCP connection; empty: none is required
  std::vector<std::string> hosts{};    // further names of this server, without a port, in addition to local ones
  bool any_host{};                     // true: accept any host name
  std::vector<std::string> origins{};  // whose pages may call, in addition to local ones: "https://marker.example"
};

[[nodiscard]] bool host_allowed(const Access& access, std::string_view host);
// `host` is the allowed Host header: a page that this server itself has served has it as its origin.
[[nodiscard]] bool origin_allowed(const Access& access, std::string_view origin, std::string_view host = {});

// Compares in constant time for tokens of the same length.  Always true if no token is required.
[[nodiscard]] bool token_matches(const Access& access, std::string_view token);
// The value of an Authorization header: "Bearer TOKEN".
[[nodiscard]] bool authorization_matches(const Access& access, std::string_view value);

}  // namespace selvage::server::transport::access
