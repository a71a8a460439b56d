// A WebSocket client for tests, which controls every frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tests/server/wire/wire.h"

namespace selvage::test {

enum class Opcode : std::uint8_t { kContinuation = 0, kText = 1, kBinary = 2, kClose = 8, kPing = 9, kPong = 10 };

struct Frame {
  Opcode opcode{};
  std::string payload;
  bool last{true};  // of its message
  // The code of a close frame; 0 if it has none.
  [[nodiscard]] int close_code() const {
    return payload.size() < 2 ? 0
                              : (static_cast<unsigned char>(payload[0]) << 8) | static_cast<unsigned char>(payload[1]);
  }
};

// The bytes of a frame as a client sends it.
[[nodiscard]] std::string frame_bytes(const Frame& frame, bool masked = true);
// A well-formed request for /ws.
[[nodiscard]] std::string upgrade_request(std::string_view more_fields = "");

class WebSocketWire {
 public:
  // Requests the upgrade; status() is the status of the answer.
  explicit WebSocketWire(std::uint16_t port, std::string_view more_fields = "");

  [[nodiscard]] int status() const { return status_; }
  [[nodiscard]] Wire& wire() { return wire_; }
  void send(const Frame& frame) { wire_.send(frame_bytes(frame)); }
  void send_text(std::string text) { send({Opcode::kText, std::move(text)}); }
  // The next frame, or nothing if the connection has ended.
  [[nodiscard]] std::optional<Frame> frame();
  // The next text message; earlier pings are answered and skipped.
  [[nodiscard]] std::optional<std::string> text();

 private:
  Wire wire_;
  int status_{};
};

}  // namespace selvage::test
