#include "clients/cpp/address.h"

#include <charconv>
#include <cstdint>
#include <system_error>

namespace selvage::client {
namespace {

bool is_port(std::string_view text) {
  std::uint16_t port{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), port);
  return read.ec == std::errc{} && read.ptr == text.data() + text.size() && port > 0;
}

}  // namespace

std::optional<Address> read_address(std::string_view text) {
  constexpr std::string_view kUnix = "unix:", kTls = "tls://";
  const bool tls = text.starts_with(kTls);
  if (tls) text.remove_prefix(kTls.size());
  if (text.find("://") != std::string_view::npos && !text.starts_with(kUnix)) return std::nullopt;
  const bool is_path = text.starts_with(kUnix) || text.find('/') != std::string_view::npos;
  if (text.starts_with(kUnix)) text.remove_prefix(kUnix.size());
  if (is_path) {
    constexpr std::size_t kLongestPath = 107;  // of a Unix socket
    if (tls || text.empty() || text.size() > kLongestPath) return std::nullopt;
    return Address{"", "", std::string{text}, false};
  }
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos || !is_port(text.substr(colon + 1))) return std::nullopt;
  std::string_view host = text.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) {
    host = host.substr(1, host.size() - 2);
  } else if (host.find(':') != std::string_view::npos) {
    return std::nullopt;
  }
  if (host.empty()) return std::nullopt;
  return Address{std::string{host}, std::string{text.substr(colon + 1)}, "", tls};
}

}  // namespace selvage::client
