// A call whose parameters were understood: everything that serving it takes, with no JSON left to look into.
#pragma once

#include <any>
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

// What a method works with besides the marker.  REQUIRES: everything outlives the call.
struct MethodContext {
  const scene::Run& run;
  // The marker laid out, kept for later calls; null: nobody keeps it.
  const execution::MadeOnce<scene::LaidOut>* laid_out{};
  // Whether the run was stopped by its deadline, rather than by its caller.
  std::function<bool()> past_deadline = [] { return false; };
  // The stored markers that are nearest to an order, at most so many; empty: there is no library.
  std::function<std::vector<Marker>(const Marker& order, std::size_t most)> library{};
};
[[nodiscard]] std::shared_ptr<const scene::LaidOut> laid_out(const Marker& marker, const MethodContext& context);
[[nodiscard]] StopCause stop_cause(scene::StopReason reason, const MethodContext& context);

struct MethodAnswer {
  Json fields;                 // all but markerId and revision
  std::optional<Marker> next;  // the marker's next state; none: it stays as it is
};

// Runs a method on a marker.  Errors: 10xx for a parameter that does not suit this marker, `field` pointing into the
// parameters; others when the marker does not allow the motion.
using MarkerRun = std::function<Result<MethodAnswer>(const MarkerFile&, const MethodContext&)>;

// Where a call runs, how long it may take and what it may change.
enum class MethodKind {
  kImmediate,  // on the thread that read the call: nothing in it takes time
  kRead,       // reads or writes whole markers; calls of one opId run one after another
  kAnalysis,   // computes something about a marker and leaves it as it is; has a deadline
  kSearch,     // the same, for as long as a motion: in no marker's order
  kStep,       // changes a marker by at most one piece, or by hand, in the marker's order
  kMotion,     // changes a marker in rounds, in the marker's order
  kDrag,       // belongs to a drag session
};

struct ParsedCall {
  std::string_view method;
  MethodKind kind{};
  CommonParams about;  // those of them that the method has
  std::any params;     // the method's own parameters, of the type in its descriptor
  MarkerRun run;       // empty when the method does not work on one marker; then the server serves it from `params`

  // Calls of one lane run one after another.  Empty: in any order.
  [[nodiscard]] const std::string& lane() const {
    static const std::string kNone;
    if (kind == MethodKind::kRead) return about.op_id ? *about.op_id : kNone;
    return kind == MethodKind::kStep || kind == MethodKind::kMotion ? about.marker_id : kNone;
  }
  // Calls that may compute for long: the server bounds their time even when they have no deadline of their own.
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
