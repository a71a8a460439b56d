// Bytes that are no sound HTTP request, WebSocket frame or line, for connections of their own: each must end with the
// connection closed, answered or not.
#pragma once

#include <string>

#include "tests/support/random.h"

namespace selvage::trials {

[[nodiscard]] std::string malformed_http(test::Random& random);
// What follows a sound upgrade to /ws.
[[nodiscard]] std::string malformed_frames(test::Random& random);

}  // namespace selvage::trials
