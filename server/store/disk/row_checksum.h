// The checksum that each row of the store carries: the CRC-32 of its table's name and its columns, each with its type
// and length, so that a row in which a bit has changed, or which has come into another table or under another key, does
// not match it.
#pragma once

#include <cstdint>
#include <string_view>

namespace selvage::server::store::disk {

class RowChecksum {
 public:
  void add(std::int64_t value);
  void add(std::string_view value);
  // A value of a type that rows do not have.
  void add_unknown();
  [[nodiscard]] std::int64_t value() const { return static_cast<std::int64_t>(sum_); }

 private:
  void add_bytes(const void* bytes, std::size_t count);

  unsigned long sum_{};
};

}  // namespace selvage::server::store::disk
