#include "server/calls/params_checksum.h"

#include <string_view>

namespace selvage::server::calls {
namespace {

// FNV-1a, 64 bits.
class Hash {
 public:
  Hash& add(std::string_view bytes) {
    for (const char byte : bytes) value_ = (value_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    return *this;
  }
  Hash& add(std::uint64_t value) {
    for (int shift = 0; shift < 64; shift += 8) value_ = (value_ ^ (value >> shift & 0xffU)) * 0x100000001b3U;
    return *this;
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_{0xcbf29ce484222325U};
};

std::uint64_t hash_of(const Json& value, bool outermost) {
  if (value.is_object()) {
    std::uint64_t sum = 0;  // the same in any order
    for (const auto& [key, field] : value.items()) {
      if (outermost && (key == "deadlineMs" || key == "progressToken")) continue;
      sum += Hash{}.add(key).add(hash_of(field, false)).value();
    }
    return Hash{}.add("{").add(sum).value();
  }
  Hash hash;
  if (value.is_array()) {
    hash.add("[");
    for (const Json& element : value) hash.add(hash_of(element, false));
    return hash.value();
  }
  if (value.is_number()) return hash.add("#").add(protocol::json::number_text(value.number())).value();
  return hash.add("=").add(protocol::json::to_text(value)).value();
}

}  // namespace

std::int64_t params_checksum(const Json& params) {
  const auto sum = static_cast<std::int64_t>(hash_of(params, true));
  return sum == 0 ? 1 : sum;
}

}  // namespace selvage::server::calls
