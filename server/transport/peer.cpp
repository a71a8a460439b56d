#include "server/transport/peer.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>

namespace selvage::server::transport {

std::string peer_of(connections::Socket& socket, const access::Listener& listener) {
  if (!listener.path.empty()) return listener.path;
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  auto* const any = reinterpret_cast<sockaddr*>(&storage);
  if (::getpeername(socket.native_handle(), any, &size) != 0) return "unknown";  // it has gone
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (storage.ss_family == AF_INET) {
    const auto* address = reinterpret_cast<const sockaddr_in*>(&storage);
    ::inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size());
    return std::string{text.data()} + ":" + std::to_string(ntohs(address->sin_port));
  }
  const auto* address = reinterpret_cast<const sockaddr_in6*>(&storage);
  ::inet_ntop(AF_INET6, &address->sin6_addr, text.data(), text.size());
  return "[" + std::string{text.data()} + "]:" + std::to_string(ntohs(address->sin6_port));
}

}  // namespace selvage::server::transport
