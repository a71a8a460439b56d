// A server that is a part of the test: it sends only the answers that the test chooses, and breaks connections.
#pragma once

#include <gtest/gtest.h>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>

#include <optional>
#include <string>

#include "tests/clients/cpp/live_daemon.h"

namespace selvage::test {

class StagedDaemon {
 public:
  [[nodiscard]] std::string address() const { return "127.0.0.1:" + std::to_string(acceptor_.local_endpoint().port()); }
  void accept_only() {
    received_.clear();
    socket_.emplace(acceptor_.accept());
  }
  // Accepts a connection and tells the daemon's instance, for which the client asks first.
  void accept(const std::string& instance = "first") {
    accept_only();
    const Json asked = receive();
    EXPECT_EQ(asked["method"], "engine.info");
    answer(asked["id"], {{"instance", instance}});
  }
  Json receive() {
    const std::size_t size = boost::asio::read_until(*socket_, boost::asio::dynamic_buffer(received_), '\n');
    Json message = Json::parse(received_.substr(0, size));
    received_.erase(0, size);
    return message;
  }
  void answer(const Json& id, const Json& result) { send({{"jsonrpc", "2.0"}, {"id", id}, {"result", result}}); }
  void refuse(const Json& id) {
    const Json error{{"code", CallCode::kBusy}, {"message", "the server is loading its markers"}};
    send({{"jsonrpc", "2.0"}, {"id", id}, {"error", error}});
  }
  void disconnect() { socket_.reset(); }
  void stop_listening() { acceptor_.close(); }

 private:
  void send(const Json& message) { boost::asio::write(*socket_, boost::asio::buffer(message.dump() + "\n")); }

  boost::asio::io_context io_;
  boost::asio::ip::tcp::acceptor acceptor_{io_, {boost::asio::ip::address_v4::loopback(), 0}};
  std::optional<boost::asio::ip::tcp::socket> socket_;
  std::string received_;
};

}  // namespace selvage::test
