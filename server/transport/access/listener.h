// Where the daemon listens, and which protocols it speaks there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/transport/access/access.h"

namespace selvage::server::transport::access {

struct Listener {
  enum class Speaks {
    kHttp,    // HTTP, WebSocket and newline-delimited JSON, distinguished by the first byte that is not blank
    kLines,   // newline-delimited JSON
    kHealth,  // HTTP: /healthz and /readyz only, without token, TLS or limits on connections
  };
  Speaks speaks{};
  std::string host{};    // a numeric address
  std::uint16_t port{};  // 0: any free port
  std::string path{};    // if not empty, a Unix socket at this path, open to its owner only, instead of TCP
};

// PEM files: the server's certificate chain and its private key.
struct TlsFiles {
  std::string certificate;
  std::string key;
};

// Everything that the transport listens on.
struct ListenSettings {
  std::vector<Listener> listeners{};
  Access access{};                // for every TCP listener; a Unix socket is protected by its permissions
  std::optional<TlsFiles> tls{};  // for every TCP listener
};

}  // namespace selvage::server::transport::access
