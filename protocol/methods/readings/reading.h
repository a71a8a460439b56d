// Methods that tell of a marker and leave it as it is.
#pragma once

#include <string>

#include "protocol/calls/method.h"

namespace selvage::protocol::methods::readings {

// marker.get {"markerId", "format"?, "since"?}
struct MarkerGet {
  std::string marker_id;
  std::optional<Revision> since;  // only what changed after it, where that is known (the server knows)
  Format format{Format::kNative};
};
[[nodiscard]] Result<MarkerGet> decode_marker_get(const Json& params);

// marker.check and marker.hold {"markerId", "deadlineMs"?}
struct MarkerStudy {
  std::string marker_id;
  std::optional<double> deadline_ms;  // the server's business
};
[[nodiscard]] Result<MarkerStudy> decode_marker_study(const Json& params);

// The `read` of such a method: `decode` makes its typed parameters, with a `marker_id`, of JSON; `work` runs it.
template <auto decode, auto work>
Result<calls::MarkerCall> read_reading(const Json& params) {
  auto wanted = decode(params);
  if (!wanted) return wanted.error();
  calls::MarkerCall call;
  call.about.marker_id = wanted->marker_id;
  if constexpr (requires { wanted->deadline_ms; }) call.about.deadline_ms = wanted->deadline_ms;
  call.run = [wanted = *std::move(wanted)](const MarkerFile& file, const calls::MethodContext& context) {
    return work(wanted, file, context);
  };
  return call;
}

}  // namespace selvage::protocol::methods::readings
