// Bytes that are not a valid HTTP request, WebSocket frame or line, each for a connection of its own, which must end
// closed, with or without an answer.
#pragma once

#include <string>

#include "tests/support/random.h"

namespace selvage::trials {

[[nodiscard]] std::string malformed_http(test::Random& random);
// Bytes after a valid upgrade to /ws.
[[nodiscard]] std::string malformed_frames(test::Random& random);

}  // namespace selvage::trials
