// One connection, over TCP or a Unix socket, for any protocol.  Everything here belongs to the I/O thread.
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
#include <string_view>

#include "server/transport/access/service.h"
#include "server/transport/waiting/bulk_turns.h"

namespace selvage::server::transport::connections {

using Socket = boost::asio::generic::stream_protocol::socket;

// The service that answers a connection, the limits and access rules that it has to respect, and the turns that it
// takes for the parts of long messages.
struct ConnectionContext {
  const access::Service& service;
  const access::TransportLimits& limits;
  const access::Access& access;
  waiting::BulkTurns& turns;
};

// Increments a count for as long as it lives.
class Counted {
 public:
  explicit Counted(std::atomic<std::size_t>& count) : count_{count} { ++count_; }
  ~Counted() { --count_; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;

 private:
  std::atomic<std::size_t>& count_;
};

// Counts and reports that a caller was refused.
void report(access::Refusal refusal, const std::string& peer, const access::Service& service);

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  using Time = std::chrono::steady_clock::time_point;
  // Whether the connection may be closed to make room for another.
  enum class Standing {
    kSilent,  // yes: no complete request, or no correct token, has arrived yet
    kIdle,    // yes: it waits for the next HTTP request
    kServed,  // no
  };

  // `id` and `peer` are those of the session.
  Connection(Socket connected, std::uint64_t id, std::string peer, bool needs_token,
             std::shared_ptr<memory::ByteAccount> account = nullptr);

  // From now on, detects when the connection breaks.
  void watch();
  // For use while calls are in progress: also detects a close by the client.  Not for protocols with half-closing.
  void watch_for_end();
  // Closes the socket unless the watchdog is disarmed, or armed again, in time.
  void arm(boost::asio::steady_timer& watchdog, std::chrono::milliseconds time);
  static void disarm(boost::asio::steady_timer& watchdog);
  // Restarts the watchdog if it is armed.  Call this when there has been progress.
  void extend(boost::asio::steady_timer& watchdog, std::chrono::milliseconds time);
  void set_standing(Standing standing);
  [[nodiscard]] Standing standing() const { return standing_; }
  [[nodiscard]] Time standing_since() const { return standing_since_; }
  // Waits until the account has room for `bytes`, or until the connection ends, for at most `time`.  Does not wait if
  // the account could never have so much room.  `held`: the bytes that the connection holds in the account already.
  boost::asio::awaitable<bool> wait_for_room(const memory::ByteAccount& account, std::size_t held, std::size_t bytes,
                                             std::chrono::milliseconds time);
  // The number of bytes that answering the message takes in addition to its own, according to the service.  Takes a
  // turn for each part of a long message but the last.
  static boost::asio::awaitable<std::size_t> weigh(const ConnectionContext& context, std::string_view message);
  // Stops reading; calls in progress are still answered.  If `on_drain` is set, calls that instead.
  void drain();
  // Closes it immediately.
  void cut();
  // Closes it properly after an answer that was sent before everything was read.  Closing with unread bytes would
  // discard the answer (TCP reset), so further bytes are read and dropped for a while.
  boost::asio::awaitable<void> linger();

  Socket socket;
  boost::asio::steady_timer read_watchdog;
  boost::asio::steady_timer write_watchdog;
  std::stop_source gone;  // stops when the client has disconnected
  const std::shared_ptr<access::Session> session;
  const bool needs_token;
  bool draining{};
  std::function<void()> on_drain;

 private:
  Standing standing_{};
  Time standing_since_{std::chrono::steady_clock::now()};
  bool watching_for_end_{};
};

// Serve one connection until it ends.  `received`: the bytes that were already read; for HTTP they start with a byte
// that is not blank.
boost::asio::awaitable<void> serve_http(std::shared_ptr<Connection> connection, const ConnectionContext& context,
                                        std::string received);
boost::asio::awaitable<void> serve_lines(std::shared_ptr<Connection> connection, const ConnectionContext& context,
                                         std::string received);

}  // namespace selvage::server::transport::connections
