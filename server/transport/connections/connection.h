// One connection, over TCP or a Unix socket, whatever is spoken on it.  Everything here belongs to the I/O thread.
#pragma once

#include <utility>  // before Asio 1.74, which uses std::exchange without it

#include <boost/asio/awaitable.hpp>
#include <boost/asio/basic_stream_socket.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "server/transport/access/service.h"

namespace selvage::server::transport::connections {

using Socket = boost::asio::generic::stream_protocol::socket;

// What every connection is served by, and within what.
struct ConnectionTerms {
  const access::Service& service;
  const access::TransportLimits& limits;
  const access::Access& access;
};

// One more in a count, as long as it lives.
class Counted {
 public:
  explicit Counted(std::atomic<std::size_t>& count) : count_{count} { ++count_; }
  ~Counted() { --count_; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;

 private:
  std::atomic<std::size_t>& count_;
};

// Something that a coroutine waits for.  A wait may end without reason: wait in a loop that looks at the
// condition.
class Signal {
 public:
  explicit Signal(const boost::asio::any_io_executor& executor) : timer_{executor} {}

  boost::asio::awaitable<void> wait() {
    boost::system::error_code ignored;
    timer_.expires_at(std::chrono::steady_clock::time_point::max());
    co_await timer_.async_wait(boost::asio::redirect_error(boost::asio::use_awaitable, ignored));
  }
  void notify() { timer_.cancel(); }

 private:
  boost::asio::steady_timer timer_;
};

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  // `id`: of its session.
  Connection(Socket connected, std::uint64_t id, bool needs_token);

  // Notices a connection that breaks, from now on.
  void watch();
  // While calls run: notices too that the other side has closed.  For protocols without half-closing only.
  void watch_for_end();
  // Closes the socket unless disarmed, or armed anew, in time.
  void arm(boost::asio::steady_timer& watchdog, std::chrono::milliseconds time);
  static void disarm(boost::asio::steady_timer& watchdog);
  // Reads nothing more; what was asked is still answered.  By `on_drain`, when that is set.
  void drain();
  // Ends it now.
  void cut();
  // Ends it in order after an answer that came before all was read: closing with unread bytes would take the
  // answer back (TCP reset), so what still comes is read and dropped for a while.
  boost::asio::awaitable<void> linger();

  Socket socket;
  boost::asio::steady_timer read_watchdog;
  boost::asio::steady_timer write_watchdog;
  std::stop_source gone;  // asked to stop when the other side is no longer there
  const std::shared_ptr<access::Session> session;
  const bool needs_token;
  bool draining{};
  std::function<void()> on_drain;

 private:
  bool watching_for_end_{};
};

// Serve one connection until it ends.  `received`: what was read already, for HTTP starting with a byte that is not
// blank.
boost::asio::awaitable<void> serve_http(std::shared_ptr<Connection> connection, const ConnectionTerms& terms,
                                        std::string received);
boost::asio::awaitable<void> serve_lines(std::shared_ptr<Connection> connection, const ConnectionTerms& terms,
                                         std::string received);

}  // namespace selvage::server::transport::connections
