// A call whose parameters have been decoded: how it is scheduled and what it does.  The JSON of its parameters is not
// looked at again.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "protocol/json/json_text.h"
#include "server/calls/open_call.h"
#include "server/calls/outcome.h"
#include "server/methods/context.h"

namespace selvage::server::methods {

struct ParsedCall {
  // Answers the call, now or later; at most once.
  std::function<void(const std::shared_ptr<calls::OpenCall>&)> run;
  std::string marker_id{};              // the marker that the call is about; empty: none
  std::string op_id{};                  // the client's name for the call, for retries; empty: none
  std::optional<double> deadline_ms{};  // from the call's arrival; the caller asked for it
  bool on_large_marker{};               // even a read that is usually quick takes long
};

// The errors of decoding are those of the parameters.
using Decode = std::function<Result<ParsedCall>(const Json& params, const ServerContext& server)>;

// How a method is scheduled.
enum class Schedule {
  kInline,      // immediately, on the thread that read the call
  kRead,        // on a worker for reads; retries of one call are executed in order of arrival
  kLongRead,    // likewise, but one worker is left to other reads; ends at the server's time limit
  kChange,      // on a worker for changes, one change of a marker at a time; ends at the server's time limit
  kLongChange,  // likewise, but one worker is left to other changes
};

struct Method {
  std::string_view name;
  Schedule schedule{};
  Decode decode;
};

// Copies the fields that scheduling and logging need from the typed parameters.
template <class Request>
void copy_common_fields(const Request& request, ParsedCall& call) {
  if constexpr (requires { request.call; }) {
    copy_common_fields(request.call, call);
  } else if constexpr (std::is_same_v<Request, std::string>) {
    call.marker_id = request;
  } else {
    if constexpr (requires { request.marker_id; }) call.marker_id = request.marker_id;
    if constexpr (requires { request.op_id; }) call.op_id = request.op_id.value_or("");
  }
}

// The `decode` of a method that is one function of its typed parameters: Outcome run(Request&, const ServerContext&,
// OpenCall&).
template <auto decode_params, auto run>
Result<ParsedCall> decode_and_run(const Json& params, const ServerContext& server) {
  auto decoded = decode_params(params);
  if (!decoded) return decoded.error();
  ParsedCall call;
  copy_common_fields(*decoded, call);
  call.run = [request = *std::move(decoded), &server](const std::shared_ptr<calls::OpenCall>& open) mutable {
    open->answer(run(request, server, *open));
  };
  return call;
}

}  // namespace selvage::server::methods
