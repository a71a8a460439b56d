// One client of a daemon: a line connection or a WebSocket on which many calls may be in progress.  A connection that
// ends, or an answer that does not arrive in time (test::kPatience), throws an exception.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "tests/server/wire/websocket_wire.h"
#include "tests/server/wire/wire.h"
#include "tests/trials/live/live_daemon.h"

namespace selvage::trials {

// The messages that the trials write and read have a library's type, because the trials use only the wire format.
using Json = nlohmann::ordered_json;

enum class Endpoint { kShared, kTcp, kUnix, kWebSocket };  // kShared: lines on HTTP's port
inline constexpr int kEndpoints = 4;

[[nodiscard]] std::string call_text(const Json& id, const std::string& method, const Json& params);
// The code of an error; 0 for a result.
[[nodiscard]] int code_of(const Json& answer);

class Caller {
 public:
  Caller(const LiveDaemon& daemon, Endpoint endpoint);

  void send_text(std::string text);
  // The next message of any kind; nothing if the connection has ended.
  [[nodiscard]] std::optional<std::string> next_text();

  // Sends a call and returns its id.
  int send(const std::string& method, const Json& params);
  void notify(const std::string& method, const Json& params);
  // The next answer; earlier notifications are counted and skipped.
  [[nodiscard]] Json next_answer();
  // Send a call while none is in progress and return its answer, or only its result (throws if it is an error).
  [[nodiscard]] Json ask(const std::string& method, const Json& params = Json::object());
  Json result(const std::string& method, const Json& params = Json::object());

  [[nodiscard]] std::size_t notifications() const { return notifications_; }
  [[nodiscard]] test::Wire& wire() { return line_ ? *line_ : socket_->wire(); }

 private:
  std::unique_ptr<test::Wire> line_;
  std::unique_ptr<test::WebSocketWire> socket_;
  int last_id_{};
  std::size_t notifications_{};
};

}  // namespace selvage::trials
