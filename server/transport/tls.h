// TLS in front of a connection: what comes is decrypted, what goes is encrypted, and behind it everything speaks plain.
//
// The plain side is one end of a socket pair, so that connections know only one kind of socket, and Beast is compiled
// for only one.  Closing carries over both ways: close_notify is half-closing, a connection that breaks is broken.
// Everything here belongs to the I/O thread.
#pragma once

#include <functional>
#include <memory>

#include "server/transport/access/listener.h"
#include "server/transport/connections/connection.h"

namespace selvage::server::transport {

class Tls {
 public:
  // Throws a std::exception that names the file when one cannot be used.  `changed`: called when a tunnel has ended.
  Tls(const access::TlsFiles& files, const access::TransportLimits& limits, std::function<void()> changed);
  ~Tls();
  Tls(const Tls&) = delete;
  Tls& operator=(const Tls&) = delete;

  // Gives the plain side of `outside`; the handshake goes on meanwhile, and in vain closes both.
  [[nodiscard]] connections::Socket unwrap(connections::Socket outside);
  // No tunnel is open: everything has been sent.
  [[nodiscard]] bool idle() const;
  // Ends all of them now.
  void cut();

 private:
  struct Inside;
  const std::shared_ptr<Inside> inside_;
};

}  // namespace selvage::server::transport
