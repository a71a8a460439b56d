// A checksum of a call's parameters, by which a retry is told from another call under the same `opId`.
//
// The order of fields does not matter, nor how a number is written.  `deadlineMs` and `progressToken` are left out,
// because they do not change what the call does.
#pragma once

#include <cstdint>

#include "protocol/json/json_text.h"

namespace selvage::server::calls {

// Never 0.
[[nodiscard]] std::int64_t params_checksum(const Json& params);

}  // namespace selvage::server::calls
