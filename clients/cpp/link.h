// One connection to a daemon: lines out, lines in.  It never outlives its use: once close() was called, or the
// connection broke, it says nothing more.
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

class Link : public std::enable_shared_from_this<Link> {
 public:
  struct Listener {
    std::function<void()> connected;
    std::function<void(const std::string& line)> heard;
    std::function<void(const std::string& why)> failed;      // the connection could not be made, or broke
    std::function<void(const std::string& why)> distrusted;  // nor will it be: TLS could not be agreed upon
  };

  Link(boost::asio::io_context& io, Listener listener);
  ~Link();
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  // Begins to connect, once.  `trusted`: as of Settings.
  void open(const Address& address, const std::string& trusted);
  // In order; what is sent before the connection is made is lost.
  void send(std::string_view line);
  void close();

 private:
  using Error = boost::system::error_code;
  using Socket = boost::asio::generic::stream_protocol::socket;

  void connect(const std::vector<Socket::endpoint_type>& endpoints);
  void shake_hands();
  void connected();
  void read();
  void write();
  void fail(const Error& error);
  void distrust(const Error& error);

  Listener listener_;
  Address address_;
  std::string trusted_;
  boost::asio::ip::tcp::resolver resolver_;
  Socket socket_;
  struct Tls;
  std::unique_ptr<Tls> tls_;  // round the socket, when the address wants it
  bool closed_{};
  std::string received_, unsent_, writing_;
};

}  // namespace selvage::client
