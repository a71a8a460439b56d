// JSON-RPC 2.0: the envelope of every call and answer.
//
// Parameters are passed by name only.  A batch holds at most kMaxBatch calls.  A call without an id is a notification
// and is never answered.  Codes never change their meaning.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "protocol/json/json_text.h"

namespace selvage::protocol::rpc {

enum class RpcCode : int {
  kParseError = -32700,
  kInvalidRequest = -32600,
  kMethodNotFound = -32601,
  kInvalidParams = -32602,
  kInternalError = -32603,

  kMotionRefused = -32000,  // the marker does not allow this motion; data says why

  kBusy = -32010,           // the queue is full; data.retryAfterMs
  kTooLarge = -32011,       // the text is longer than the server accepts; data.limit
  kUnknownMarker = -32012,  // no marker of this id
  kLimit = -32013,          // a limit of this server, such as the number of open markers; data.limit
  kDraining = -32014,       // the server is shutting down and accepts no new calls
  kUnauthorised = -32015,   // the connection has not sent the token

  kCancelled = -32800,         // the client asked to stop
  kRevisionMismatch = -32801,  // the marker has another revision now, which is data.revision
  kSuperseded = -32802,        // a newer call of the same kind has replaced this one
};

inline constexpr std::size_t kMaxBatch = 100;

struct RpcError {
  RpcCode code{};
  std::string message;
  Json data;  // null: none
};

struct Request {
  std::optional<Json> id;  // string, number or null; absent: a notification
  std::string method;
  Json params = Json::object();  // an object; or an array, which every decoder refuses
};

// A call that is not a valid request.  It is answered with this error, under its id or, if that is unusable, null.
struct BadRequest {
  Json id;
  RpcError error;
};

using Call = std::variant<Request, BadRequest>;

struct Incoming {
  bool batch{};  // the answers are sent as one array, even if there is only one
  std::vector<Call> calls;
};

// Never fails: text that is not JSON or not a call is returned as a BadRequest.  A batch that is empty or too long is
// one BadRequest and no batch.
[[nodiscard]] Incoming parse_incoming(std::string_view text, std::size_t max_bytes);

[[nodiscard]] Json response(const Json& id, Json result);
// The same as text, for a result that is text already.
[[nodiscard]] std::string response_text(const Json& id, std::string_view result);
[[nodiscard]] Json error_response(const Json& id, const RpcError& error);

// A notification from the server; it has no id and is not answered.
[[nodiscard]] Json notification(std::string_view method, Json params);

// An Error of the core or the codec as a JSON-RPC error, with its own code, name and field in `data`: {"code": 1102,
// "name": "shape.zero_area", "field": "/marker/shapes/0/outline"}.
[[nodiscard]] RpcError rpc_error(const Error& error, RpcCode code = RpcCode::kInvalidParams);

}  // namespace selvage::protocol::rpc
