#include "tests/server/wire/websocket_wire.h"

#include <array>

namespace selvage::test {

std::string upgrade_request(std::string_view more_fields) {
  std::string request = "GET /ws HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n";
  request += "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  return request.append(more_fields) + "\r\n";
}

std::string frame_bytes(const Frame& frame, bool masked) {
  constexpr std::array<unsigned char, 4> kMask{0x12, 0x34, 0x56, 0x78};
  const auto byte = [](std::size_t value) { return static_cast<char>(value & 0xff); };
  const std::size_t size = frame.payload.size();
  const std::size_t mask_bit = masked ? 0x80 : 0;
  std::string bytes{byte((frame.last ? 0x80U : 0U) | static_cast<unsigned>(frame.opcode))};
  const int length_bytes = size < 126 ? 0 : size < 65536 ? 2 : 8;
  bytes += byte(mask_bit | (length_bytes == 0 ? size : length_bytes == 2 ? 126 : 127));
  for (int i = length_bytes - 1; i >= 0; --i) bytes += byte(size >> (8 * i));
  if (!masked) return bytes + frame.payload;
  for (const unsigned char mask : kMask) bytes += byte(mask);
  for (std::size_t i = 0; i < size; ++i) bytes += byte(static_cast<unsigned char>(frame.payload[i]) ^ kMask.at(i % 4));
  return bytes;
}

WebSocketWire::WebSocketWire(std::uint16_t port, std::string_view more_fields) : wire_{port} {
  wire_.send(upgrade_request(more_fields));
  status_ = wire_.answer().value_or(HttpAnswer{}).status;
}

std::optional<Frame> WebSocketWire::frame() {
  const std::string start = wire_.bytes(2);
  if (start.size() < 2) return std::nullopt;
  const auto first = static_cast<unsigned char>(start[0]);
  std::size_t size = static_cast<unsigned char>(start[1]);
  if (size >= 126) {
    const std::string length = wire_.bytes(size == 126 ? 2 : 8);
    size = 0;
    for (const char c : length) size = (size << 8) | static_cast<unsigned char>(c);
  }
  return Frame{static_cast<Opcode>(first & 0x0f), wire_.bytes(size), (first & 0x80) != 0};
}

std::optional<std::string> WebSocketWire::text() {
  std::string message;  // a long one comes in several frames
  for (;;) {
    auto next = frame();
    if (!next || next->opcode == Opcode::kClose) return std::nullopt;
    if (next->opcode == Opcode::kPing) send({Opcode::kPong, next->payload});
    if (next->opcode != Opcode::kText && next->opcode != Opcode::kContinuation) continue;
    message += next->payload;
    if (next->last) return message;
  }
}

}  // namespace selvage::test
