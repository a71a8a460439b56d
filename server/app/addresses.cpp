#include "server/app/addresses.h"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <charconv>

namespace selvage::server::app {
namespace {

bool is_ipv4(const std::string& host) {
  in_addr address{};
  return ::inet_pton(AF_INET, host.c_str(), &address) == 1;
}

bool is_ipv6(const std::string& host) {
  in6_addr address{};
  return ::inet_pton(AF_INET6, host.c_str(), &address) == 1;
}

}  // namespace

std::variant<TcpAddress, std::string> read_address(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return "expected HOST:PORT, such as 127.0.0.1:7171";
  TcpAddress address{.host = std::string{text.substr(0, colon)}};
  const std::string_view port = text.substr(colon + 1);
  const auto [end, mistake] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (port.empty() || mistake != std::errc{} || end != port.data() + port.size()) {
    return "the port must be a number from 0 to 65535, not '" + std::string{port} + "'";
  }
  const std::string written = address.host;
  if (written == "localhost") address.host = "127.0.0.1";
  const bool bracketed = written.size() > 2 && written.front() == '[' && written.back() == ']';
  if (bracketed) address.host = written.substr(1, written.size() - 2);
  if (bracketed ? !is_ipv6(address.host) : !is_ipv4(address.host)) {
    return "'" + written + "' is not an address; use localhost or a numeric address, IPv6 in brackets";
  }
  return address;
}

std::string address_text(const TcpAddress& address) {
  const bool ipv6 = address.host.find(':') != std::string::npos;
  return (ipv6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
}

bool is_loopback(const std::string& host) {
  return host == "::1" || (is_ipv4(host) && host.starts_with("127."));
}

}  // namespace selvage::server::app
