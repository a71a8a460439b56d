#include "server/calls/params_checksum.h"

#include "core/base/fnv1a.h"

namespace selvage::server::calls {
namespace {

std::uint64_t hash_of(const Json& value, bool outermost) {
  if (value.is_object()) {
    std::uint64_t sum = 0;  // the same in any order
    for (const auto& [key, field] : value.items()) {
      if (outermost && (key == "deadlineMs" || key == "progressToken")) continue;
      sum += Fnv1a{}.add(key).add(hash_of(field, false)).value();
    }
    return Fnv1a{}.add("{").add(sum).value();
  }
  Fnv1a hash;
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
