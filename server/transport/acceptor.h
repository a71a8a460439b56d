// An open listener.
#pragma once

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include "server/transport/access/listener.h"
#include "server/transport/connections/connection.h"

namespace selvage::server::transport {

class Acceptor {
 public:
  // Listens at once.  A Unix socket that nobody listens on any more is replaced.  Throws a std::exception that names
  // the address when it cannot be taken.
  Acceptor(boost::asio::io_context& io, access::Listener listener);
  ~Acceptor();  // close()
  Acceptor(const Acceptor&) = delete;
  Acceptor& operator=(const Acceptor&) = delete;

  // The next connection; `error` is operation_aborted once the acceptor is closed.
  boost::asio::awaitable<connections::Socket> accept(boost::system::error_code& error);
  // Out of file descriptors, say: some will come back.
  boost::asio::awaitable<void> pause();
  // Takes nothing more; a Unix socket's path is removed.
  void close();

  [[nodiscard]] bool is_open() const { return acceptor_.is_open(); }
  [[nodiscard]] const access::Listener& listener() const { return listener_; }  // with the port that was taken

 private:
  access::Listener listener_;
  boost::asio::basic_socket_acceptor<boost::asio::generic::stream_protocol> acceptor_;
  boost::asio::steady_timer pause_;
};

}  // namespace selvage::server::transport
