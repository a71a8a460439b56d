// Every method on the markers that are open, given a thread to do it on.  No sockets, no queues: params in,
// result or error out.
#pragma once

#include <optional>
#include <stop_token>
#include <string_view>
#include <variant>

#include "protocol/json_rpc.h"
#include "protocol/marker_methods.h"
#include "server/limits.h"
#include "server/marker_store.h"

namespace selvage {

using Outcome = std::variant<Json, RpcError>;

// Who wants a motion to stop.
struct Stops {
  std::stop_token any;     // for whatever reason: hand back the best so far
  std::stop_token caller;  // the caller is gone: the answer reaches nobody, so nothing is committed
};

// Where a method runs: at once on the thread that read the call, on a worker for reads, or on a worker for
// motions in its marker's lane.
enum class Place { kAtOnce, kRead, kMotion };
// Nothing when there is no method of this name.
[[nodiscard]] std::optional<Place> place_of(std::string_view method);

class Methods {
 public:
  Methods(MarkerStore& store, SumCache& sums, const Limits& limits, std::size_t workers, Engine engine)
      : store_{store}, sums_{sums}, limits_{limits}, workers_{workers}, engine_{std::move(engine)} {}

  // REQUIRES: place_of knows the method.
  [[nodiscard]] Outcome call(std::string_view method, const Json& params, const Stops& stops);

  // The methods about markers as a whole; those that work on one are in protocol/marker_methods.h.
  [[nodiscard]] Outcome engine_info(const Json& params);
  [[nodiscard]] Outcome marker_open(const Json& params);
  [[nodiscard]] Outcome marker_close(const Json& params);

 private:
  [[nodiscard]] Outcome call_on_marker(const MarkerMethod& method, const Json& params, const Stops& stops);

  MarkerStore& store_;
  SumCache& sums_;
  const Limits limits_;
  const std::size_t workers_;
  const Engine engine_;
};

}  // namespace selvage
