// What a method on one marker is: its name, its words, and how it is read and run.
//
// A method's parameters are read first, without the marker; what was read then runs on a marker and answers with fields
// and, when it changed the marker, with its next state.  Which markers there are, their revisions, threads and clocks
// are the caller's.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

#include "protocol/calls/engine.h"
#include "protocol/calls/words.h"
#include "protocol/execution/made_once.h"
#include "protocol/formats/format.h"
#include "protocol/json/json_text.h"

namespace selvage::protocol::calls {

using Revision = std::uint64_t;  // 1 when a marker is opened, one more with every change

// What a method works with besides the marker.  REQUIRES: all outlive the call.
struct MethodContext {
  const Engine& engine;
  const scene::Run& run;
  const execution::MadeOnce<scene::LaidOut>*
      laid_out{};  // of the marker at hand, kept for whoever comes next; null: nobody keeps it
};
[[nodiscard]] std::shared_ptr<const scene::LaidOut> laid_out(const Marker& marker, const MethodContext& context);

struct MethodAnswer {
  Json fields;                 // all but markerId and revision
  std::optional<Marker> next;  // the marker's next state; none: it stays as it is
};

// What every motion takes: {"markerId", "baseRev"?, "commit"?, "timing"?, "opId"?, "deadlineMs"?, "progressToken"?}.
// The last three are the server's business.
struct MotionCall {
  std::string marker_id;
  std::optional<Revision> base_revision;  // refuse when the marker is at another
  bool commit{true};                      // false: answer, but leave the marker as it is
  bool timing{};                          // answer with the times and the cache's counts, which vary from run to run
  std::optional<std::string> op_id;       // the client's name for the call: a retry of it gets the same answer
  std::optional<double> deadline_ms;      // from the call's arrival: then the best so far is wanted
  Json progress_token;                    // a string or a number to tell rounds under; null: they are not told
};

// A call whose parameters were understood.
struct MarkerCall {
  MotionCall about;  // for methods that are no motions only its marker
  // Errors: 10xx for a parameter that does not suit this marker, `field` pointing into the parameters; others
  // when the marker does not allow the motion.
  std::function<Result<MethodAnswer>(const MarkerFile&, const MethodContext&)> run;
};

// What a method does, and whether it may take long: where it runs goes by this.
enum class MethodKind {
  kTell,   // tells of the marker at hand
  kStudy,  // tells of it what takes working out
  kStep,   // changes it at once, by at most one piece
  kMove,   // changes it, in rounds
};

struct MarkerMethod {
  std::string_view name;
  MethodKind kind{};
  [[nodiscard]] bool motion() const { return kind == MethodKind::kStep || kind == MethodKind::kMove; }
  // Errors: 10xx, `field` pointing into the parameters.
  Result<MarkerCall> (*read)(const Json& params);
  MethodWords words{};  // its own; openrpc.h adds what every such method takes and answers
};

}  // namespace selvage::protocol::calls

// Vocabulary: named in selvage itself as well, so that every room may use it unqualified.
namespace selvage {
using protocol::calls::Revision;
}  // namespace selvage
