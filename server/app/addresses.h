// Addresses as they are written on a command line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace selvage::server::app {

struct TcpAddress {
  std::string host;  // in numbers, IPv6 without brackets
  std::uint16_t port{};
};

// "127.0.0.1:7171", "[::1]:0", "localhost:7171"; a text that says what is wrong when it is none of these.
[[nodiscard]] std::variant<TcpAddress, std::string> read_address(std::string_view text);
// "127.0.0.1:7171", "[::1]:7171".
[[nodiscard]] std::string address_text(const TcpAddress& address);
// Reached from this machine only.  REQUIRES: an address in numbers.
[[nodiscard]] bool is_loopback(const std::string& host);

}  // namespace selvage::server::app
