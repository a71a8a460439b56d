// What all motions on the wire have in common: the parameters that every one of them takes, the figures that every one
// answers with, and how one of them becomes a MarkerMethod.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/motion/compaction/compact.h"
#include "protocol/calls/method.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::calls {

inline constexpr int kMaxRounds = 100'000;
inline constexpr double kMostSimplification = 1;
inline constexpr double kLargestForce = 1e9, kLeastForce = 1e-9;  // of either coordinate; of the larger one
inline constexpr std::string_view kAccuracyNames[] = {"draft", "standard", "fine"};  // by Accuracy
inline constexpr std::string_view kStopNames[] = {"converged", "work_limit", "cancelled",
                                                  "solver_failed"};  // by StopReason
[[nodiscard]] std::string_view name_of(scene::StopReason reason);

// What every motion in rounds takes: {"accuracy"?, "rounds"?, "simplification"?}
struct Effort {
  motion::compaction::Accuracy accuracy{motion::compaction::Accuracy::kStandard};
  std::optional<int> rounds;             // instead of the accuracy's own limit
  std::optional<double> simplification;  // instead of the accuracy's own; a part of the strip's width
};
[[nodiscard]] motion::compaction::CompactionSettings settings_of(const Effort& effort);

// [x, y]: where to, never (0, 0).
struct Direction {
  double x{}, y{};
};

// Readers of the parameters above.
[[nodiscard]] MotionCall read_call(json::Fields& fields, json::Mistake& mistake);
[[nodiscard]] Effort read_effort(json::Fields& fields);
[[nodiscard]] std::optional<int> read_rounds(json::Fields& fields);
[[nodiscard]] Direction read_direction(json::Fields& fields, std::string_view key, json::Mistake& mistake);

// The marker's piece of this id; `field` is the parameter that names it.
[[nodiscard]] Result<PieceId> piece_of(const Marker& marker, const std::string& id, const std::string& field);

// What a motion comes to.
struct Motion {
  Marker marker;
  Json figures;  // the motion's own
  motion::repair::Repair repair;
  bool keep_invalid{};                             // what is not valid is kept, too: the caller asked for it
  std::shared_ptr<const scene::LaidOut> before{};  // the marker it began with, when it laid that out as a whole
};
// {"rounds", "stop"}
[[nodiscard]] Json rounds_json(int rounds, scene::StopReason reason);
// Proves the motion's marker valid and puts the answer together.
[[nodiscard]] MethodAnswer answer_of(const Marker& start, Motion motion, bool commit, const MethodContext& context);

// The `read` of a motion: `decode` makes its typed parameters, with a MotionCall `call`, of JSON; `work` runs it.
template <auto decode, auto work>
Result<MarkerCall> read_motion(const Json& params) {
  auto wanted = decode(params);
  if (!wanted) return wanted.error();
  MarkerCall call;
  call.about = wanted->call;
  call.run = [wanted = *std::move(wanted)](const MarkerFile& file,
                                           const MethodContext& context) -> Result<MethodAnswer> {
    Result<Motion> done = work(wanted, file.marker, context);
    if (!done) return done.error();
    return answer_of(file.marker, *std::move(done), wanted.call.commit, context);
  };
  return call;
}

}  // namespace selvage::protocol::calls
