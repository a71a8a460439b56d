// Who is at the other end of a connection.
#pragma once

#include <string>

#include "server/transport/access/listener.h"
#include "server/transport/connections/connection.h"

namespace selvage::server::transport {

struct Peer {
  std::string text;     // "192.0.2.7:40112", "[2001:db8::1]:40112", or the path of the Unix socket
  std::string address;  // whose connections are limited: an IPv4 address or the /64 network of an IPv6 address; empty
                        // for a Unix socket
};
// REQUIRES: not yet behind TLS.
[[nodiscard]] Peer peer_of(connections::Socket& socket, const access::Listener& listener);

}  // namespace selvage::server::transport
