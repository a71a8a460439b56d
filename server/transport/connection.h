// One TCP connection, whatever is spoken on it.  Everything here belongs to the I/O thread.
#pragma once

#include <utility>  // before Asio 1.74, which uses std::exchange without it

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>

#include <chrono>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>

#include "server/transport/service.h"

namespace selvage {

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
  Connection(boost::asio::ip::tcp::socket connected, std::uint64_t id);

  // Notices a connection that breaks, from now on.
  void watch();
  // While calls run: notices too that the other side has closed.  For protocols without half-closing only.
  void watch_for_end();
  // Closes the socket unless disarmed, or armed anew, in time.
  void arm(boost::asio::steady_timer& watchdog, std::chrono::milliseconds time);
  static void disarm(boost::asio::steady_timer& watchdog);
  // Reads nothing more; what was asked is still answered.
  void drain();
  // Ends it now.
  void cut();
  // Ends it in order after an answer that came before all was read: closing with unread bytes would take the
  // answer back (TCP reset), so what still comes is read and dropped for a while.
  boost::asio::awaitable<void> linger();

  boost::asio::ip::tcp::socket socket;
  boost::asio::steady_timer read_watchdog;
  boost::asio::steady_timer write_watchdog;
  std::stop_source gone;  // asked to stop when the other side is no longer there
  const std::shared_ptr<Session> session;
  bool draining{};

 private:
  bool watching_for_end_{};
};

// Serve one connection until it ends.  `received`: what was read already, starting with a byte that is not
// blank.
boost::asio::awaitable<void> serve_http(std::shared_ptr<Connection> connection, const Service& service,
                                        const TransportLimits& limits, std::string received);
boost::asio::awaitable<void> serve_lines(std::shared_ptr<Connection> connection, const Service& service,
                                         const TransportLimits& limits, std::string received);

}  // namespace selvage
