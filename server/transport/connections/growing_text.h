// How the buffer grows for a text that arrives in parts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

namespace selvage::server::transport::connections {

// Makes room for `bytes` more bytes.  A text of some hundred kilobytes gets room for megabytes, and a text of megabytes
// gets room for the longest possible one.  Unused address space costs nothing, but copying the text would block every
// other connection.  REQUIRES: text.size() + bytes <= most.
inline void make_room(std::string& text, std::size_t bytes, std::size_t most) {
  constexpr std::size_t kSmall = std::size_t{256} << 10, kLarge = std::size_t{4} << 20;
  const std::size_t needed = text.size() + bytes;
  if (needed <= text.capacity()) return;
  text.reserve(needed < kSmall ? needed : needed < kLarge ? std::min(kLarge, most) : most);
}

}  // namespace selvage::server::transport::connections
