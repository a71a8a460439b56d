// JSON as text: a strict reader with limits, and a writer whose decimals are exact.
//
// The reader refuses text that would cause problems later: nesting deeper than kMaxDepth, objects with more than
// kMaxFields fields, duplicate keys, more values than a 16th of the allowed bytes, numbers beyond the range of double,
// and invalid UTF-8.  The writer prints every double as its shortest decimal that reads back as the same double
// (std::to_chars): a lattice coordinate that came through to_decimal is printed exactly.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "protocol/json/value.h"

namespace selvage::protocol::json {

inline constexpr int kMaxDepth = 64;
inline constexpr std::size_t kMaxFields = 256;                       // of one object
inline constexpr std::size_t kMaxFileBytes = std::size_t{64} << 20;  // of a marker read from a file

// The maximum number of values in a text whose length has this limit.
[[nodiscard]] std::size_t most_values(std::size_t max_bytes);

// Errors: kSyntax (with line and column), kDepth, kOutOfRange (the text is too long or has too many values, a number
// overflows, an object has too many fields), kDuplicateField.
[[nodiscard]] Result<Json> parse(std::string_view text, std::size_t max_bytes = kMaxFileBytes);

enum class Layout { kCompact, kIndented };
// Compact text is one line without blanks.  Indented text has one field per line, except that short objects and arrays
// that contain no object stay on one line.  Neither ends with a newline.  REQUIRES: every number is finite.
[[nodiscard]] std::string to_text(const Json& value, Layout layout = Layout::kCompact);

// The shortest decimal that reads back as `value`; plain digits between 1e-6 and 1e15, an exponent beyond.
[[nodiscard]] std::string number_text(double value);

// `value` for an error message: its compact text, at most `most` characters of it.
[[nodiscard]] std::string shortened(const Json& value, std::size_t most = 60);

}  // namespace selvage::protocol::json
