// A method: its name, its descriptor, and how its parameters are turned into a call that can be run.
//
// Parameters are decoded first, without the marker; the call then runs on a marker and answers with fields and, when it
// changed the marker, with the marker's next state.  The caller is responsible for open markers, their revisions,
// threads and clocks.
#pragma once

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "protocol/calls/parsed_call.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::calls {

struct Method {
  std::string_view name, summary;
  MethodKind kind{};
  // Errors: 10xx, `field` pointing into the parameters.
  std::function<Result<ParsedCall>(const Json& params)> read;
  std::vector<schema::FieldDescription> (*params)(){};
  std::vector<schema::FieldDescription> (*results)(){};
  // Decodes the parameters and encodes them again, with defaults filled in and in the descriptor's order.  Errors:
  // those of `read`.  Null for methods that the server executes itself.
  Result<Json> (*canonical)(const Json& params){};
  bool on_marker{};  // the call's `run` is set, so the command line can also run the method on a file
  bool motion{};     // moves pieces by itself, unlike an edit by hand
};

// The parameters that concern the call itself, as far as the message has them.
template <class Params>
CommonParams common_of(const Params& params) {
  if constexpr (requires { params.call; }) {
    return common_of(params.call);
  } else if constexpr (std::is_same_v<Params, CommonParams>) {
    return params;
  } else {
    CommonParams about;
    if constexpr (requires { params.marker_id; }) about.marker_id = params.marker_id;
    if constexpr (requires { params.base_revision; }) about.base_revision = params.base_revision;
    if constexpr (requires { params.commit; }) about.commit = params.commit;
    if constexpr (requires { params.op_id; }) about.op_id = params.op_id;
    if constexpr (requires { params.deadline_ms; }) about.deadline_ms = params.deadline_ms;
    if constexpr (requires { params.progress_token; }) about.progress_token = params.progress_token;
    return about;
  }
}

template <class Params>
Result<Json> canonical_params(const Json& params) {
  const Result<Params> read = schema::decode<Params>(params);
  if (!read) return read.error();
  return schema::encode(*read);
}

// A method that the server executes itself, from the typed parameters of the call.
template <class Params, class Answer>
[[nodiscard]] Method served_method(std::string_view name, MethodKind kind, std::string_view summary) {
  const auto read = [name, kind](const Json& params) -> Result<ParsedCall> {
    Result<Params> wanted = schema::decode<Params>(params);
    if (!wanted) return wanted.error();
    CommonParams about = common_of(*wanted);
    return ParsedCall{name, kind, std::move(about), *std::move(wanted), nullptr};
  };
  return {name, summary, kind, read, &schema::describe<Params>, &schema::describe<Answer>};
}

}  // namespace selvage::protocol::calls
