// Where the daemon listens, and what is spoken there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/transport/access/access.h"

namespace selvage::server::transport::access {

struct Listener {
  enum class Speaks {
    kHttp,   // HTTP and WebSocket; and lines of JSON, told apart by the first byte that is not blank
    kLines,  // newline-delimited JSON
  };
  Speaks speaks{};
  std::string host{};    // a numeric address
  std::uint16_t port{};  // 0: a free one
  std::string path{};    // not empty: a Unix socket there, open to its owner only, instead of TCP
};

// PEM files: the server's certificate with its chain, and its private key.
struct TlsFiles {
  std::string certificate;
  std::string key;
};

struct Doors {
  std::vector<Listener> listeners{};
  Access access{};                // of every TCP listener; a Unix socket's permissions are its own
  std::optional<TlsFiles> tls{};  // on every TCP listener
};

}  // namespace selvage::server::transport::access
