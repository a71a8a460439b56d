#include "protocol/methods/compact.h"

#include <array>

#include "protocol/methods/families.h"

namespace selvage {
namespace {

Result<Motion> run(const MotionCompact& wanted, const Marker& start, const Means& means) {
  // Whoever says how to go about a compaction asks for that alone.
  const Effort& effort = wanted.effort;
  const bool search = effort.accuracy == Accuracy::kFine && !effort.rounds && !effort.simplification;
  auto done = search ? means.engine.refine(start, refine_settings(), means.sums, means.stop, means.observer)
                     : means.engine.compact(start, settings_of(effort), means.sums, means.stop, means.observer);
  if (!done) return done.error();
  return Motion{std::move(done->marker), rounds_json(done->rounds, done->reason), done->healing};
}

constexpr std::array kMethods{
    MarkerMethod{"motion.compact",
                 MethodKind::kMove,
                 &read_motion<decode_motion_compact, run>,
                 {"The marker made shorter, all pieces moving at once.", kEffortParams, kRoundsResults}}};

}  // namespace

Result<MotionCompact> decode_motion_compact(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionCompact compact;
  compact.call = read_call(fields, mistake);
  compact.effort = read_effort(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return compact;
}

std::span<const MarkerMethod> compaction_methods() {
  return kMethods;
}

}  // namespace selvage
