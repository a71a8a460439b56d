// Small documents for the tests of the protocol.
#pragma once

#include <string>

#include "protocol/formats/format.h"
#include "protocol/json/json_text.h"

namespace selvage::test {

// Two 40 x 40 squares, "left" at (0, 0) and "right" at (50, 10), on a strip 100 wide, in the native form.
Json native_squares();
// The same layout as a sparrow solution.
Json sparrow_squares();

// REQUIRES: the text is JSON.
Json json(const std::string& text);
// REQUIRES: the document is a marker.
MarkerFile read(const Json& document);

}  // namespace selvage::test
