#include "server/transport/peer.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

namespace selvage::server::transport {

namespace {

Peer peer_at(const sockaddr_in& address) {
  std::array<char, INET_ADDRSTRLEN> text{};
  ::inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size());
  return {std::string{text.data()} + ":" + std::to_string(ntohs(address.sin_port)), text.data()};
}

Peer peer_at(const sockaddr_in6& address) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  ::inet_ntop(AF_INET6, &address.sin6_addr, text.data(), text.size());
  const std::string whole = "[" + std::string{text.data()} + "]:" + std::to_string(ntohs(address.sin6_port));
  if (IN6_IS_ADDR_V4MAPPED(&address.sin6_addr)) return {whole, text.data()};
  in6_addr network = address.sin6_addr;  // the smallest network of a customer
  std::fill(std::begin(network.s6_addr) + 8, std::end(network.s6_addr), std::uint8_t{0});
  ::inet_ntop(AF_INET6, &network, text.data(), text.size());
  return {whole, text.data()};
}

}  // namespace

Peer peer_of(connections::Socket& socket, const access::Listener& listener) {
  if (!listener.path.empty()) return {listener.path, {}};
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  auto* const any = reinterpret_cast<sockaddr*>(&storage);
  if (::getpeername(socket.native_handle(), any, &size) != 0) return {"unknown", "unknown"};  // it has gone
  if (storage.ss_family == AF_INET) return peer_at(*reinterpret_cast<const sockaddr_in*>(&storage));
  return peer_at(*reinterpret_cast<const sockaddr_in6*>(&storage));
}

}  // namespace selvage::server::transport
