#include "server/store/disk/row_checksum.h"

#include <zlib.h>

#include <bit>

namespace selvage::server::store::disk {

// A file is only read by machines with the same byte order as the one that wrote it.
static_assert(std::endian::native == std::endian::little);

void RowChecksum::add_bytes(const void* bytes, std::size_t count) {
  if (count == 0) return;  // zlib would begin anew for a null pointer
  sum_ = crc32_z(sum_, static_cast<const unsigned char*>(bytes), count);
}

void RowChecksum::add(std::int64_t value) {
  add_bytes("i", 1);
  add_bytes(&value, sizeof value);
}

void RowChecksum::add(std::string_view value) {
  const std::uint64_t count = value.size();
  add_bytes("t", 1);
  add_bytes(&count, sizeof count);
  add_bytes(value.data(), value.size());
}

void RowChecksum::add_unknown() {
  add_bytes("?", 1);
}

}  // namespace selvage::server::store::disk
