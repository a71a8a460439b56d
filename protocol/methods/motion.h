// What all motions on the wire have in common: the parameters that every one of them takes, the figures that every one
// answers with, and how one of them becomes a MarkerMethod.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/motion/compact.h"
#include "protocol/fields.h"
#include "protocol/methods/method.h"

namespace selvage {

inline constexpr int kMaxRounds = 100'000;
inline constexpr double kMostSimplification = 1;
inline constexpr double kLargestForce = 1e9, kLeastForce = 1e-9;  // of either coordinate; of the larger one
inline constexpr std::string_view kAccuracyNames[] = {"draft", "standard", "fine"};  // by Accuracy
inline constexpr std::string_view kStopNames[] = {"converged", "work_limit", "cancelled",
                                                  "solver_failed"};  // by StopReason
[[nodiscard]] std::string_view name_of(StopReason reason);

// What every motion in rounds takes: {"accuracy"?, "rounds"?, "simplification"?}
struct Effort {
  Accuracy accuracy{Accuracy::kStandard};
  std::optional<int> rounds;             // instead of the accuracy's own limit
  std::optional<double> simplification;  // instead of the accuracy's own; a part of the strip's width
};
[[nodiscard]] CompactionSettings settings_of(const Effort& effort);

// [x, y]: where to, never (0, 0).
struct Direction {
  double x{}, y{};
};

// Readers of the parameters above.
[[nodiscard]] MotionCall read_call(Fields& fields, Mistake& mistake);
[[nodiscard]] Effort read_effort(Fields& fields);
[[nodiscard]] std::optional<int> read_rounds(Fields& fields);
[[nodiscard]] Direction read_direction(Fields& fields, std::string_view key, Mistake& mistake);

// The marker's piece of this id; `field` is the parameter that names it.
[[nodiscard]] Result<PieceId> piece_of(const Marker& marker, const std::string& id, const std::string& field);

// What a motion comes to.
struct Motion {
  Marker marker;
  Json figures;  // the motion's own
  Healing healing;
  bool keep_invalid{};                      // what is not valid is kept, too: the caller asked for it
  std::shared_ptr<const LaidOut> before{};  // the marker it began with, when it laid that out as a whole
};
// {"rounds", "stop"}
[[nodiscard]] Json rounds_json(int rounds, StopReason reason);
// Proves the motion's marker valid and puts the answer together.
[[nodiscard]] MethodAnswer answer_of(const Marker& start, Motion motion, bool commit, const Means& means);

// The `read` of a motion: `decode` makes its typed parameters, with a MotionCall `call`, of JSON; `work` runs it.
template <auto decode, auto work>
Result<MarkerCall> read_motion(const Json& params) {
  auto wanted = decode(params);
  if (!wanted) return wanted.error();
  MarkerCall call;
  call.about = wanted->call;
  call.run = [wanted = *std::move(wanted)](const MarkerFile& file, const Means& means) -> Result<MethodAnswer> {
    Result<Motion> done = work(wanted, file.marker, means);
    if (!done) return done.error();
    return answer_of(file.marker, *std::move(done), wanted.call.commit, means);
  };
  return call;
}

}  // namespace selvage
