// What the transport needs to know of those who answer, and they of it: text in, text out.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>

namespace selvage {

// Whoever is at the other end of a connection.
struct Session {
  std::uint64_t id{};                       // of no other session of this process
  std::function<void(std::string)> notify;  // sends a message that is no answer, from any thread; empty on plain HTTP
  std::stop_token gone;                     // stops when the connection has ended
};

// Takes the answer to one message: call it once, from any thread.  Empty text: nothing is to be sent.
using Reply = std::function<void(std::string)>;

struct Service {
  // Answers one message.  Called on the I/O thread: must not block.  `caller` stops when the connection is
  // gone.
  std::function<void(std::string message, std::stop_token caller, Reply reply)> call;
  // The body of GET /healthz.  Called on the I/O thread.
  std::function<std::string()> health;
  // What is sent for a line longer than the limit.
  std::string line_too_long;
};

struct TransportLimits {
  std::size_t body_bytes{std::size_t{32} << 20};  // of an HTTP body, and of one line
  std::size_t header_bytes{std::size_t{8} << 10};
  std::size_t connections{512};          // open at once; more are closed at the door
  std::size_t calls_per_connection{64};  // unanswered on one line connection; it is not read while it has more
  std::size_t backlog_bytes{std::size_t{16} << 20};  // unsent on one line connection; likewise
  std::chrono::milliseconds idle{300'000};    // between two HTTP requests, and before the first byte of a connection
  std::chrono::milliseconds request{30'000};  // from the first byte of a header, a body or a line to its last
  std::chrono::milliseconds write{30'000};    // for the other side to take what is sent to it
};

}  // namespace selvage
