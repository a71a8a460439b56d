// The answer to a call: a result, or an error with a code.  Errors are values; nothing here throws.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>

namespace selvage::client {

using Json = nlohmann::ordered_json;  // keeps the order of fields

// The daemon's codes are negative (protocol/README.md explains them); the client's own are positive.  No code ever
// changes its meaning.  A newer daemon may return codes that are not listed here.
enum class CallCode : int {
  kInvalidRequest = -32600,
  kMethodNotFound = -32601,
  kInvalidParams = -32602,  // details["field"] names the parameter
  kInternalError = -32603,
  kMotionRefused = -32000,  // the marker does not allow this motion
  kBusy = -32010,           // details["retryAfterMs"]
  kTooLarge = -32011,       // the call is longer than the daemon accepts
  kUnknownMarker = -32012,
  kLimit = -32013,
  kDraining = -32014,
  kUnauthorised = -32015,
  kCancelled = -32800,
  kRevisionMismatch = -32801,  // details["revision"] is the current one
  kSuperseded = -32802,        // replaced by a newer move of the same drag

  kBadAddress = 1,    // the address is invalid
  kUnreachable = 2,   // no connection within the time limit
  kDisconnected = 3,  // the connection broke; the call may have been carried out, so it is not sent again
  kEnded = 4,         // the client was destroyed before the answer arrived
  kUntrusted = 5      // the TLS handshake failed: the certificate is not trusted, or the daemon does not use TLS
};

struct CallError {
  CallCode code{};
  std::string message;  // names the field, the value and what is allowed
  Json details;         // the "data" of the error; null when there is none

  // The name of the error, such as "marker.overlaps"; empty when the daemon gave none.
  [[nodiscard]] std::string name() const;
};

class [[nodiscard]] Answer {
 public:
  Answer(Json result) : held_{std::in_place_index<0>, std::move(result)} {}     // NOLINT(google-explicit-constructor)
  Answer(CallError error) : held_{std::in_place_index<1>, std::move(error)} {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] explicit operator bool() const { return held_.index() == 0; }
  // REQUIRES: holds a result.
  [[nodiscard]] const Json& operator*() const { return std::get<0>(held_); }
  [[nodiscard]] const Json* operator->() const { return &std::get<0>(held_); }
  // REQUIRES: holds an error.
  [[nodiscard]] const CallError& error() const { return std::get<1>(held_); }

 private:
  std::variant<Json, CallError> held_;
};

// The answer that a JSON-RPC response contains.
[[nodiscard]] Answer answer_in(const Json& response);

}  // namespace selvage::client
