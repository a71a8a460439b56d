// The interface between the transport and the service that answers its messages: text in, text out.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "server/memory/byte_account.h"
#include "server/transport/access/access.h"
#include "server/transport/access/refusal.h"

namespace selvage::server::transport::access {

// The client at the other end of a connection.
struct Session {
  std::uint64_t id{};                       // unique in this process
  std::function<void(std::string)> notify;  // sends a notification, from any thread; empty on plain HTTP
  std::stop_token gone;                     // stops when the connection has ended
  std::string peer{};                       // the client's address, or the path of the Unix socket that it uses
  // Of the bytes that clients make the server hold; null: nobody counts.
  std::shared_ptr<memory::ByteAccount> account{};
};

// Takes the answer to one message: call it once, from any thread.  Nothing is sent for an empty text.
using Reply = std::function<void(std::string)>;

// The answer to the first message of a connection that must authenticate, and whether it may continue.
struct Authentication {
  bool granted{};
  std::string answer;
};

// A file that anyone may GET, such as a part of the page in the browser.
struct StaticFile {
  std::string_view type;    // its media type
  std::string_view policy;  // its Content-Security-Policy; none if empty
  std::string_view gzip;    // its content, compressed
  bool forever{};           // its name changes with its content, so browsers may keep it
};

// Written by the transport, read by anyone.
struct TransportCounts {
  std::atomic<std::uint64_t> accepted{}, turned_away{};                // connections since the start
  std::atomic<std::size_t> http{}, lines{}, websockets{};              // connections open now
  std::array<std::atomic<std::uint64_t>, kRefusals.size()> refused{};  // connections and requests, by Refusal
};

// Every function is called on the I/O thread.
struct Service {
  // Answers one message.  Must not block.  The session is the same for all messages of one connection.  The connection
  // keeps it alive; whoever wants to notify it later may hold a shared or a weak pointer.
  std::function<void(std::string message, const std::shared_ptr<Session>& session, Reply reply)> call;
  // How many bytes it takes to answer a message, besides its own; none if it is empty.  The weights of the parts of a
  // message are added.
  std::function<std::size_t(std::string_view message)> weigh{};
  // Whether calls are refused for a while because of the service's start: they are passed on, and over HTTP answered
  // with status 503.  Empty: they are not.
  std::function<bool()> loading{};
  // The GET requests below are answered 404 if their function is empty.
  // The body of GET /healthz, JSON: the process is alive.
  std::function<std::string()> health{};
  // The body of GET /readyz: the reason why no work should be sent here now (503), or empty (200).
  std::function<std::string()> ready{};
  // The body of GET /metrics, in Prometheus' text format 0.0.4.
  std::function<std::string()> metrics{};
  // The body of GET /openrpc.json.
  std::function<std::string()> openrpc{};
  // The file at a path, served without a token; null if there is none.
  std::function<const StaticFile*(std::string_view path)> file{};
  // Checks the token in the first message of a line connection, or of a WebSocket whose upgrade request had none.  If
  // it is empty, no such connection is accepted.
  std::function<Authentication(std::string_view message, const Access& access)> authenticate{};
  // Called for every refusal after it has been counted.
  std::function<void(Refusal refusal, const std::string& peer)> on_refused{};
  // The answer to a line that is longer than the limit.
  std::string line_too_long{};
  // The answer to a message that is dropped because the account has no room.
  std::string no_room{};
  const std::shared_ptr<memory::ByteAccount> account = std::make_shared<memory::ByteAccount>();
  const std::shared_ptr<TransportCounts> counts = std::make_shared<TransportCounts>();
};

struct TransportLimits {
  std::size_t body_bytes{std::size_t{32} << 20};   // of an HTTP body, of one line, of one WebSocket message
  std::size_t header_bytes{std::size_t{8} << 10};  // of an HTTP request, and of a message that must contain a token
  std::size_t connections{512};                    // open at the same time, without those for health checks
  std::size_t connections_per_address{512};        // of these; for IPv6 of a /64 network
  std::size_t health_connections{32};              // for health checks; the oldest makes room for a further one
  std::size_t calls_per_connection{
      64};  // in progress on one line or WebSocket connection, which is not read while there are more
  std::size_t request_bytes{std::size_t{32} << 20};  // of these calls, and of what answering them takes; likewise
  std::size_t backlog_bytes{std::size_t{16} << 20};  // not yet sent on one such connection; likewise
  // Of all connections: requests that are received or answered, with what answering them takes, and answers not yet
  // sent.  Then no connection is read between messages, and a message that has begun is refused unless there is room in
  // time.
  std::size_t traffic_bytes{std::size_t{512} << 20};
  std::chrono::milliseconds room{5'000};      // for room for a message that has begun
  std::chrono::milliseconds idle{300'000};    // between two HTTP requests, and before the first byte of a connection
  std::chrono::milliseconds request{30'000};  // from the first byte of a header, a body or a message to its last
  std::chrono::milliseconds write{30'000};    // for the client to take some of what is sent to it
  std::chrono::milliseconds ping{20'000};     // between two pings on a WebSocket
  std::chrono::milliseconds silence{60'000};  // of a WebSocket client that does not answer pings
};

}  // namespace selvage::server::transport::access
