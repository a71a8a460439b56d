// TLS in front of a connection: what comes is decrypted, what goes is encrypted, and behind it everything speaks plain.
//
// The plain side is one end of a socket pair, so that connections know only one kind of socket, and Beast is compiled
// for only one.  Closing carries over both ways: close_notify is half-closing, a connection that breaks is broken.
// Everything here belongs to the I/O thread.
#pragma once

#include <functional>
#include <memory>

#include "server/transport/connection.h"
#include "server/transport/listener.h"

namespace selvage {

class Tls {
 public:
  // Throws a std::exception that names the file when one cannot be used.  `changed`: called when a tunnel has ended.
  Tls(const TlsFiles& files, const TransportLimits& limits, std::function<void()> changed);
  ~Tls();
  Tls(const Tls&) = delete;
  Tls& operator=(const Tls&) = delete;

  // Gives the plain side of `outside`; the handshake goes on meanwhile, and in vain closes both.
  [[nodiscard]] Socket unwrap(Socket outside);
  // No tunnel is open: everything has been sent.
  [[nodiscard]] bool idle() const;
  // Ends all of them now.
  void cut();

 private:
  struct Inside;
  const std::shared_ptr<Inside> inside_;
};

}  // namespace selvage
