// TLS in front of a connection: decrypts what arrives and encrypts what is sent, so that everything behind it uses
// plain text.
//
// The plain side is one end of a socket pair, so that connections use only one kind of socket, and Beast is compiled
// for only one.  Closing is passed on in both directions: close_notify becomes half-closing, and if one side breaks,
// the other is broken, too.  Everything here belongs to the I/O thread.
#pragma once

#include <functional>
#include <memory>

#include "server/transport/access/listener.h"
#include "server/transport/connections/connection.h"

namespace selvage::server::transport {

class Tls {
 public:
  struct Credentials;  // a certificate chain and its key
  // Any thread.  Throws a std::exception that names the file if one cannot be used.
  [[nodiscard]] static std::shared_ptr<Credentials> load(const access::TlsFiles& files);

  // `on_ended` is called when a tunnel has ended.
  Tls(std::shared_ptr<Credentials> credentials, const access::TransportLimits& limits, std::function<void()> on_ended);
  ~Tls();
  Tls(const Tls&) = delete;
  Tls& operator=(const Tls&) = delete;

  // Returns the plain side of `outside` while the handshake is still in progress; if that fails, both are closed.
  [[nodiscard]] connections::Socket unwrap(connections::Socket outside);
  // For connections from now on.
  void use(std::shared_ptr<Credentials> credentials);
  // Returns true if no tunnel is open, so that everything has been sent.
  [[nodiscard]] bool idle() const;
  // Closes all tunnels immediately.
  void cut();

 private:
  struct Implementation;
  const std::shared_ptr<Implementation> implementation_;
};

}  // namespace selvage::server::transport
