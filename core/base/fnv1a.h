// FNV-1a (Fowler, Noll and Vo) with 64 bits: a hash that is the same on every machine, of bytes and of whole numbers,
// least significant byte first.  Not cryptographic.
#pragma once

#include <cstdint>
#include <string_view>

namespace selvage {

class Fnv1a {
 public:
  Fnv1a& add(std::string_view bytes) {
    for (const char byte : bytes) add_byte(static_cast<unsigned char>(byte));
    return *this;
  }
  Fnv1a& add(std::uint64_t number) {
    for (int k = 0; k < 8; ++k, number >>= 8) add_byte(number & 0xffU);
    return *this;
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  void add_byte(std::uint64_t byte) { value_ = (value_ ^ byte) * 0x100000001b3U; }

  std::uint64_t value_{0xcbf29ce484222325U};
};

}  // namespace selvage
