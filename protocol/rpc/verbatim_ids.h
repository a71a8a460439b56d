// Keeps the ids of calls exactly as they were written.
//
// A number beyond 64 bits, or with a fraction or an exponent, is read as a double, which may differ from the number
// that was sent.  Therefore such an id is sent back as the text that was received.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace selvage::protocol::rpc {

struct Incoming;

// Whether an id was read as a double.
[[nodiscard]] bool has_inexact_ids(const Incoming& incoming);
// For each call of the message, the text of its id if that is such a number, otherwise an empty text.
// REQUIRES: the text has been read as `incoming`.
[[nodiscard]] std::vector<std::string> verbatim_ids(std::string_view text, const Incoming& incoming);

}  // namespace selvage::protocol::rpc
