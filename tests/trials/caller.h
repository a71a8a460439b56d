// One client of a daemon: a line connection or a WebSocket, on which many calls may be under way.
// A connection that ends, and an answer that does not come in time (test::kPatience), throw.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "protocol/json/json_text.h"
#include "tests/server/wire/websocket_wire.h"
#include "tests/server/wire/wire.h"
#include "tests/trials/live_daemon.h"

namespace selvage::trials {

enum class Door { kShared, kTcp, kUnix, kWebSocket };  // kShared: lines on HTTP's port
inline constexpr int kDoors = 4;

[[nodiscard]] std::string call_text(const Json& id, const std::string& method, const Json& params);
// 0: it is no error.
[[nodiscard]] int code_of(const Json& answer);

class Caller {
 public:
  Caller(const LiveDaemon& daemon, Door door);

  void send_text(std::string text);
  // The next message, whatever it is; nothing when the connection has ended.
  [[nodiscard]] std::optional<std::string> next_text();

  // Sends a call; its id.
  int send(const std::string& method, const Json& params);
  void notify(const std::string& method, const Json& params);
  // The next answer; notifications before it are counted and passed over.
  [[nodiscard]] Json next_answer();
  // Sends a call while none is under way; its answer, or only its result (throws when it is an error).
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
