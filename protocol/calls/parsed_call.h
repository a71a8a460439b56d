// A call with decoded parameters: everything that is needed to execute it, so that nothing reads JSON later.
#pragma once

#include <any>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/laid_out.h"
#include "core/scene/run.h"
#include "protocol/calls/params.h"
#include "protocol/execution/made_once.h"
#include "protocol/formats/format.h"

namespace selvage::protocol::calls {

// What a method needs in addition to the marker.  REQUIRES: everything outlives the call.
struct MethodContext {
  const scene::Run& run;
  // The laid-out marker, kept for later calls; null if it is not kept.
  const execution::MadeOnce<scene::LaidOut>* laid_out{};
  // Whether the run was stopped by its deadline, rather than by its caller.
  std::function<bool()> past_deadline = [] { return false; };
  // The stored markers that are most similar to an order, at most this many.  Empty if there is no library.
  std::function<std::vector<MarkerFile>(const Marker& order, std::size_t most)> library{};
  // From when the run begins to its deadline; none if there is no deadline.
  std::optional<std::chrono::duration<double>> time_left{};
};
[[nodiscard]] std::shared_ptr<const scene::LaidOut> laid_out(const Marker& marker, const MethodContext& context);
[[nodiscard]] StopCause stop_cause(scene::StopReason reason, const MethodContext& context);

struct MethodAnswer {
  Json fields;                 // all but markerId and revision
  std::optional<Marker> next;  // the marker's next state; none if it does not change
};

// Runs a method on a marker.  Errors: 10xx for a parameter that is invalid for this marker, `field` pointing into the
// parameters; others when the marker does not allow the motion.
using MarkerRun = std::function<Result<MethodAnswer>(const MarkerFile&, const MethodContext&)>;

// Where a call runs, how long it may take and what it may change.
enum class MethodKind {
  kImmediate,  // runs on the thread that read the call, because it takes no time
  kRead,       // reads or writes whole markers; calls of one opId run one after another
  kAnalysis,   // computes something about a marker and leaves it as it is; has a deadline
  kSearch,     // the same, but takes as long as a motion; not ordered with changes of the marker
  kStep,       // edits a marker or moves one piece, in the marker's order
  kMotion,     // changes a marker in rounds, in the marker's order
  kDrag,       // belongs to a drag session
};

struct ParsedCall {
  std::string_view method;
  MethodKind kind{};
  CommonParams about;  // those that the method has
  std::any params;     // the method's own parameters, of the type in its descriptor
  MarkerRun run;       // empty if the method does not work on one marker; the server then executes it from `params`

  // Calls of one lane run one after another; if the lane is empty, in any order.
  [[nodiscard]] const std::string& lane() const {
    static const std::string kNone;
    if (kind == MethodKind::kRead) return about.op_id ? *about.op_id : kNone;
    return kind == MethodKind::kStep || kind == MethodKind::kMotion ? about.marker_id : kNone;
  }
  // Whether the call may take long.  The server limits the time of such calls even if they have no deadline.
  [[nodiscard]] bool bounded() const {
    return kind == MethodKind::kAnalysis || kind == MethodKind::kSearch || kind == MethodKind::kStep ||
           kind == MethodKind::kMotion;
  }
  // REQUIRES: Params is the type in the method's descriptor.
  template <class Params>
  [[nodiscard]] const Params& params_as() const {
    return *std::any_cast<Params>(&params);
  }
  template <class Params>
  [[nodiscard]] Params take_params() {
    return std::any_cast<Params>(std::move(params));
  }
};

}  // namespace selvage::protocol::calls
