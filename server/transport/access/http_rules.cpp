#include "server/transport/access/http_rules.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace selvage::server::transport::access {
namespace {

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

// Removes `prefix`, ignoring case, from the front.  Returns false if the text does not begin with it.
bool take(std::string_view& text, std::string_view prefix) {
  const auto same = [](char a, char b) { return lower(a) == lower(b); };
  if (text.size() < prefix.size() || !std::equal(prefix.begin(), prefix.end(), text.begin(), same)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

bool is_port(std::string_view text) {
  return !text.empty() && text.size() <= 5 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

bool is_host(std::string_view host, std::string_view name) {
  return take(host, name) && (host.empty() || (host.front() == ':' && is_port(host.substr(1))));
}

bool is_local_host(std::string_view host) {
  constexpr std::array<std::string_view, 3> kNames{"localhost", "127.0.0.1", "[::1]"};
  return std::any_of(kNames.begin(), kNames.end(), [host](std::string_view name) { return is_host(host, name); });
}

bool is_local_origin(std::string_view origin) {
  return (take(origin, "http://") || take(origin, "https://")) && is_local_host(origin);
}

bool is_origin_of(std::string_view origin, std::string_view host) {
  return !host.empty() && (take(origin, "http://") || take(origin, "https://")) && take(origin, host) && origin.empty();
}

bool take_scheme(std::string_view& authorization, std::string_view scheme) {
  if (!take(authorization, scheme) || !authorization.starts_with(' ')) return false;
  authorization.remove_prefix(std::min(authorization.find_first_not_of(' '), authorization.size()));
  return true;
}

}  // namespace selvage::server::transport::access
