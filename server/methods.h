// What each method does, given a thread to do it on.  No sockets, no queues: params in, result or error out.
#pragma once

#include <optional>
#include <stop_token>
#include <string_view>
#include <variant>

#include "protocol/json_rpc.h"
#include "server/engine.h"
#include "server/limits.h"
#include "server/marker_store.h"

namespace selvage {

using Outcome = std::variant<Json, RpcError>;

// Who wants a motion to stop.
struct Stops {
  std::stop_token any;     // for whatever reason: hand back the best so far
  std::stop_token caller;  // the caller is gone: the answer reaches nobody, so nothing is committed
};

class Methods {
 public:
  Methods(MarkerStore& store, SumCache& sums, const Limits& limits, std::size_t workers, Engine engine)
      : store_{store}, sums_{sums}, limits_{limits}, workers_{workers}, engine_{std::move(engine)} {}

  [[nodiscard]] Outcome engine_info(const Json& params, const Stops& stops);
  [[nodiscard]] Outcome marker_open(const Json& params, const Stops& stops);
  [[nodiscard]] Outcome marker_get(const Json& params, const Stops& stops);
  [[nodiscard]] Outcome marker_check(const Json& params, const Stops& stops);
  [[nodiscard]] Outcome marker_close(const Json& params, const Stops& stops);
  [[nodiscard]] Outcome motion_compact(const Json& params, const Stops& stops);

 private:
  MarkerStore& store_;
  SumCache& sums_;
  const Limits limits_;
  const std::size_t workers_;
  const Engine engine_;
};

// Where a method runs: at once on the thread that read the call, on a worker for reads, or on a worker for
// motions in its marker's lane.
enum class Place { kAtOnce, kRead, kMotion };

struct Method {
  std::string_view name;
  Place place{};
  Outcome (Methods::*run)(const Json& params, const Stops& stops);
};
// Nothing when there is no method of this name.
[[nodiscard]] std::optional<Method> find_method(std::string_view name);

}  // namespace selvage
