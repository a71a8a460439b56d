// Text as XML can hold it.
//
// XML 1.0 has no control characters below U+0020 but tabs and line ends, and neither U+FFFE nor U+FFFF, not even as
// references.  Tabs and line ends do not survive in attributes.  Errors: none; what is not valid UTF-8 stays as it is.
#pragma once

#include <string>
#include <string_view>

namespace selvage::protocol::document {

// The text with a blank in place of each of these characters.  (1) xml_text(xml_text(t)) == xml_text(t)
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace selvage::protocol::document
