// A text file as UTF-8: without its byte order mark, and converted if it is UTF-16.
//
// UTF-16 is recognised by its mark, or without one by its first four characters, if they are ASCII.  Half a pair of
// surrogates becomes U+FFFD.  Any other encoding is left to encoding_of (protocol/trade/text.h).
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace selvage::protocol::trade::unicode {

class Utf8Text {
 public:
  // REQUIRES: the bytes outlive the text.
  // Errors: kUnknownFormat for UTF-32, which the error names.
  [[nodiscard]] static Result<Utf8Text> of(std::string_view bytes);

  [[nodiscard]] std::string_view text() const { return encoding_.empty() ? given_ : std::string_view{converted_}; }
  // The encoding that it was converted from, such as "UTF-16 (little-endian)"; empty if it was not converted.
  [[nodiscard]] std::string_view encoding() const { return encoding_; }

 private:
  std::string_view given_, encoding_;
  std::string converted_;
};

}  // namespace selvage::protocol::trade::unicode
