// The address of a daemon: a TCP address, with or without TLS, or the path of a Unix socket.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace selvage::client {

struct Address {
  std::string host, port;  // TCP; IPv6 without brackets
  std::string path;        // of a Unix socket; empty: TCP
  bool tls{};
};

// "127.0.0.1:7171", "localhost:7171", "[::1]:7171", "tls://marker.example:7171"; "unix:/run/selvage.sock", or any path
// that contains a slash.  Null when the text is none of these.
[[nodiscard]] std::optional<Address> read_address(std::string_view text);

}  // namespace selvage::client
