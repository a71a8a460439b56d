// One connection to a daemon, which carries lines of text in both directions.  After close(), or once the connection
// has failed, the listener is not called again.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>

#include "clients/cpp/address.h"

namespace selvage::client {

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  struct Listener {
    std::function<void()> connected;
    std::function<void(const std::string& line)> received;
    std::function<void(const std::string& why)> failed;     // it could not be established, or it broke
    std::function<void(const std::string& why)> untrusted;  // the TLS handshake failed; trying again will not help
  };

  Connection(boost::asio::io_context& io, Listener listener);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  // Starts to connect.  `trusted`: see Settings.  REQUIRES: called once.
  void open(const Address& address, const std::string& trusted);
  // Lines are sent in order.  REQUIRES: the connection is established; lines sent before that are lost.
  void send(std::string_view line);
  void close();

 private:
  using Error = boost::system::error_code;
  using Socket = boost::asio::generic::stream_protocol::socket;

  void connect(const std::vector<Socket::endpoint_type>& endpoints);
  void start_tls();
  void connected();
  void read();
  void write();
  void fail(const Error& error);
  void fail_untrusted(const Error& error);

  Listener listener_;
  Address address_;
  std::string trusted_;
  boost::asio::ip::tcp::resolver resolver_;
  Socket socket_;
  struct Tls;
  std::unique_ptr<Tls> tls_;  // around the socket; null without TLS
  bool closed_{};
  std::string received_, unsent_, writing_;
};

}  // namespace selvage::client
