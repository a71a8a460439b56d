// What the transport needs to know of those who answer, and they of it: text in, text out.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "server/transport/access/access.h"

namespace selvage::server::transport::access {

// Whoever is at the other end of a connection.
struct Session {
  std::uint64_t id{};                       // of no other session of this process
  std::function<void(std::string)> notify;  // sends a message that is no answer, from any thread; empty on plain HTTP
  std::stop_token gone;                     // stops when the connection has ended
};

// Takes the answer to one message: call it once, from any thread.  Empty text: nothing is to be sent.
using Reply = std::function<void(std::string)>;

// What is said to the first message of a connection that must show a token in it, and whether it may stay.
struct Entry {
  bool granted{};
  std::string answer;
};

// Written by the transport, read by anyone.
struct TransportCounts {
  std::atomic<std::uint64_t> accepted{}, turned_away{};    // connections since the start
  std::atomic<std::size_t> http{}, lines{}, websockets{};  // connections open now
};

// Everything here is called on the I/O thread.
struct Service {
  // Answers one message.  Must not block.  The session is the same for all messages of one connection; its
  // connection keeps it alive, and whoever wants to notify later may hold it, weakly or not.
  std::function<void(std::string message, const std::shared_ptr<Session>& session, Reply reply)> call;
  // The GET requests below are answered 404 when nothing is there to call.
  // The body of GET /healthz, JSON: the process is alive.
  std::function<std::string()> health{};
  // GET /readyz: why no work should be sent here now, in words (503); empty when there is no reason not to (200).
  std::function<std::string()> ready{};
  // The body of GET /metrics, in Prometheus' text format 0.0.4.
  std::function<std::string()> metrics{};
  // The body of GET /openrpc.json.
  std::function<std::string()> openrpc{};
  // Judges the first message of a line connection, or of a WebSocket whose upgrade did not show it, that needs a token.
  // Nothing there to call: none is let in.
  std::function<Entry(std::string_view message, const Access& access)> enter{};
  // What is sent for a line longer than the limit.
  std::string line_too_long{};
  const std::shared_ptr<TransportCounts> counts = std::make_shared<TransportCounts>();
};

struct TransportLimits {
  std::size_t body_bytes{std::size_t{32} << 20};   // of an HTTP body, of one line, of one WebSocket message
  std::size_t header_bytes{std::size_t{8} << 10};  // of an HTTP request; and of a message that must show a token
  std::size_t connections{512};                    // open at once; more are closed at the door
  std::size_t calls_per_connection{
      64};  // unanswered on one line or WebSocket connection; it is not read while it has more
  std::size_t backlog_bytes{std::size_t{16} << 20};  // unsent on one such connection; likewise
  std::chrono::milliseconds idle{300'000};    // between two HTTP requests, and before the first byte of a connection
  std::chrono::milliseconds request{30'000};  // from the first byte of a header, a body or a message to its last
  std::chrono::milliseconds write{30'000};    // for the other side to take what is sent to it
  std::chrono::milliseconds ping{20'000};     // between two pings on a WebSocket
  std::chrono::milliseconds silence{60'000};  // of a WebSocket that answers no ping
};

}  // namespace selvage::server::transport::access
