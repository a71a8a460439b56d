// Fields that calls of many methods share.
#pragma once

#include <optional>
#include <string>

#include "protocol/calls/method.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::calls {

inline constexpr std::size_t kLongestOpId = 128;               // bytes
inline constexpr std::size_t kLongestToken = 128;              // bytes of a progress token's text
inline constexpr json::Range kDeadlines{1, 24.0 * 3'600'000};  // milliseconds

// Each is optional, and a mistake when it is there and is not as said.
// A revision: 1 to 2^53, which every client's numbers hold.
[[nodiscard]] std::optional<Revision> read_revision(json::Fields& fields, std::string_view key);
[[nodiscard]] inline std::optional<Revision> read_base_revision(json::Fields& fields) {
  return read_revision(fields, "baseRev");
}
// "opId": 1 to kLongestOpId bytes.
[[nodiscard]] std::optional<std::string> read_op_id(json::Fields& fields, json::Mistake& mistake);
// "deadlineMs": from the call's arrival, which is the server's business.
[[nodiscard]] std::optional<double> read_deadline(json::Fields& fields);
// "progressToken": a number or a string of at most kLongestToken bytes; null when it is absent.
[[nodiscard]] Json read_progress_token(json::Fields& fields, json::Mistake& mistake);

}  // namespace selvage::protocol::calls
