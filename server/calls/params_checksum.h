// A checksum of a call's parameters.  It distinguishes a retry from a different call with the same `opId`.
//
// Neither the order of fields nor the way a number is written matters.  `deadlineMs` and `progressToken` are left out,
// because they do not change what the call does.
#pragma once

#include <cstdint>

#include "protocol/json/json_text.h"

namespace selvage::server::calls {

// Never 0.
[[nodiscard]] std::int64_t params_checksum(const Json& params);

}  // namespace selvage::server::calls
