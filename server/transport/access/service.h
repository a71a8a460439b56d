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
  // Counts the bytes that clients make the server hold; if null, they are not counted.
  std::shared_ptr<memory::ByteAccount> account{};
};

// Takes the answer to one message.  Call it exactly once, from any thread.  An empty answer is not sent.
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
  // Answers one message.  Must not block.  All messages of one connection have the same session.  The connection keeps
  // the session alive; code that notifies it later may hold a shared or a weak pointer.
  std::function<void(std::string message, const std::shared_ptr<Session>& session, Reply reply)> call;
  // How many bytes answering a message takes in addition to its own bytes; 0 if the function is empty.  The weight of a
  // message is the sum of the weights of its parts.
  std::function<std::size_t(std::string_view message)> weigh{};
  // Returns true while the service is starting and refuses calls.  They are passed on nevertheless, but over HTTP the
  // status is 503.  If the function is empty, the service is never loading.
  std::function<bool()> loading{};
  // The GET requests below are answered with status 404 if their function is empty.  The body of GET /healthz, JSON:
  // the process is alive.
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
  std::size_t body_bytes{std::size_t{32} << 20};   // of an HTTP body, a line or a WebSocket message
  std::size_t header_bytes{std::size_t{8} << 10};  // of an HTTP header, or of a message that must contain a token
  std::size_t connections{512};                    // open at the same time, not counting those for health checks
  std::size_t connections_per_address{512};        // of these, from one IPv4 address or IPv6 /64 network
  std::size_t health_connections{32};              // for health checks; beyond this the oldest is closed
  std::size_t calls_per_connection{
      64};  // in progress on one line or WebSocket connection, which is not read while there are more
  std::size_t request_bytes{std::size_t{32} << 20};  // of these calls and of answering them; likewise
  std::size_t backlog_bytes{std::size_t{16} << 20};  // not yet sent on one such connection; likewise
  // Limit for all connections together: requests being received or answered, with the memory needed to answer them, and
  // answers not yet sent.  When it is reached, no connection is read between messages, and a message that has begun is
  // refused unless there is room in time.
  std::size_t traffic_bytes{std::size_t{512} << 20};
  std::chrono::milliseconds room{5'000};      // how long a message that has begun waits for room
  std::chrono::milliseconds idle{300'000};    // between two HTTP requests, and before the first byte of a connection
  std::chrono::milliseconds request{30'000};  // from the first byte of a header, a body or a message to its last
  std::chrono::milliseconds write{30'000};    // without any progress while an answer is sent
  std::chrono::milliseconds ping{20'000};     // between two pings on a WebSocket
  std::chrono::milliseconds silence{60'000};  // of a WebSocket client, which then does not answer pings
};

}  // namespace selvage::server::transport::access
