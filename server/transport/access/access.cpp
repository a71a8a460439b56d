#include "server/transport/access/access.h"

#include <openssl/crypto.h>

#include <algorithm>

#include "server/transport/access/http_rules.h"

namespace selvage::server::transport::access {

bool host_allowed(const Access& access, std::string_view host) {
  const auto names = [host](const std::string& name) { return is_host(host, name); };
  return access.any_host || !access.token.empty() || is_local_host(host) ||
         std::any_of(access.hosts.begin(), access.hosts.end(), names);
}

bool origin_allowed(const Access& access, std::string_view origin, std::string_view host) {
  return is_local_origin(origin) || is_origin_of(origin, host) ||
         std::find(access.origins.begin(), access.origins.end(), origin) != access.origins.end();
}

bool token_matches(const Access& access, std::string_view token) {
  if (access.token.empty()) return true;
  return access.token.size() == token.size() && CRYPTO_memcmp(access.token.data(), token.data(), token.size()) == 0;
}

bool authorization_matches(const Access& access, std::string_view value) {
  return access.token.empty() || (take_scheme(value, "Bearer") && token_matches(access, value));
}

}  // namespace selvage::server::transport::access
