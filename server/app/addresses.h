// Network addresses as text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace selvage::server::app {

struct TcpAddress {
  std::string host;  // a numeric address; IPv6 without brackets
  std::uint16_t port{};
};

// Reads "127.0.0.1:7171", "[::1]:0" or "localhost:7171".  Returns an error message for anything else.
[[nodiscard]] std::variant<TcpAddress, std::string> read_address(std::string_view text);
// Writes "127.0.0.1:7171" or "[::1]:7171".
[[nodiscard]] std::string address_text(const TcpAddress& address);
// Returns true if only this machine can reach the address.  REQUIRES: a numeric address.
[[nodiscard]] bool is_loopback(const std::string& host);

}  // namespace selvage::server::app
