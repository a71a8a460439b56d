// What comes of a call: its result, or an error with a code.  Errors are values; nothing here throws.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>

namespace selvage::client {

using Json = nlohmann::ordered_json;  // keeps the order of fields

// The daemon's codes (negative; protocol/README.md explains each) and the client's own (positive).  None ever changes
// its meaning.  A newer daemon may answer with codes that are not named here.
enum class CallCode : int {
  kInvalidRequest = -32600,
  kMethodNotFound = -32601,
  kInvalidParams = -32602,  // details["field"] says which
  kInternalError = -32603,
  kMotionRefused = -32000,  // the marker does not allow this motion
  kBusy = -32010,           // details["retryAfterMs"]
  kTooLarge = -32011,       // the call is longer than the daemon takes
  kUnknownMarker = -32012,
  kLimit = -32013,
  kDraining = -32014,
  kUnauthorised = -32015,
  kCancelled = -32800,
  kRevisionMismatch = -32801,  // details["revision"] is the present one
  kSuperseded = -32802,        // a newer move of the same drag took this one's place

  kBadAddress = 1,    // the address says nowhere
  kUnreachable = 2,   // no connection, for as long as the client was to try
  kDisconnected = 3,  // the connection broke, and the call must not be sent twice: it may have been carried out
  kEnded = 4,         // the client was destroyed first
  kUntrusted = 5      // no TLS with that daemon: its certificate is not trusted, or it speaks none
};

struct CallError {
  CallCode code{};
  std::string message;  // names the field, the value and what is allowed
  Json details;         // the "data" of the error; null when there is none

  // The name of what exactly is wrong, such as "marker.overlaps"; empty when the daemon gave none.
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

// The answer in a response of JSON-RPC.
[[nodiscard]] Answer answer_in(const Json& response);

}  // namespace selvage::client
