// The description of all methods that machines read: an OpenRPC 1.2.6 document (https://spec.open-rpc.org), made of
// the words that stand beside the decoders.
//
// A method's result is an object; its schema's properties are the words of its results.  What the daemon sends unasked
// is under "x-notifications": name, summary, params, as of a method.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "protocol/calls/method.h"
#include "protocol/json/json_text.h"

namespace selvage::protocol::describe {

struct ToldMethod {
  std::string_view name;
  std::string_view summary;
  std::vector<calls::Word> params, results;
};

// With what every method on a marker takes and answers, and every motion.
[[nodiscard]] ToldMethod told(const calls::MarkerMethod& method);
[[nodiscard]] ToldMethod told(std::string_view name, const calls::MethodWords& words);

// JSON Schema (draft 7) of a type of words.h.  REQUIRES: its names are those of words.h and schemas.h.
[[nodiscard]] Json type_schema(std::string_view type);

[[nodiscard]] Json openrpc_document(std::string_view version, std::span<const ToldMethod> methods);

}  // namespace selvage::protocol::describe
