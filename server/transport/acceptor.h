// A listening socket, on a TCP port or a Unix socket.
#pragma once

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include "server/transport/access/listener.h"
#include "server/transport/connections/connection.h"

namespace selvage::server::transport {

class Acceptor {
 public:
  // Listens immediately.  A Unix socket left behind by another process is replaced.  Throws a std::exception that names
  // the address if it cannot be used.
  Acceptor(boost::asio::io_context& io, access::Listener listener);
  ~Acceptor();  // close()
  Acceptor(const Acceptor&) = delete;
  Acceptor& operator=(const Acceptor&) = delete;

  // The next connection; `error` is operation_aborted when the acceptor has been closed.
  boost::asio::awaitable<connections::Socket> accept(boost::system::error_code& error);
  // Waits a moment after a failure, such as a lack of file descriptors.
  boost::asio::awaitable<void> pause();
  // Accepts no more connections; the path of a Unix socket is removed.
  void close();

  [[nodiscard]] bool is_open() const { return acceptor_.is_open(); }
  [[nodiscard]] const access::Listener& listener() const { return listener_; }  // with the actual port

 private:
  access::Listener listener_;
  boost::asio::basic_socket_acceptor<boost::asio::generic::stream_protocol> acceptor_;
  boost::asio::steady_timer pause_;
};

}  // namespace selvage::server::transport
