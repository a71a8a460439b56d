#include "protocol/methods/motions/compact.h"

#include <array>

#include "protocol/methods/motions/families.h"

namespace selvage::protocol::methods::motions {
namespace {

Result<calls::Motion> run(const MotionCompact& wanted, const Marker& start, const calls::MethodContext& context) {
  // Whoever says how to go about a compaction asks for that alone.
  const calls::Effort& effort = wanted.effort;
  const bool search =
      effort.accuracy == motion::compaction::Accuracy::kFine && !effort.rounds && !effort.simplification;
  auto done = search ? context.engine.refine(start, search::refine_settings(), context.run)
                     : context.engine.compact(start, settings_of(effort), context.run);
  if (!done) return done.error();
  return calls::Motion{std::move(done->marker), calls::rounds_json(done->rounds, done->reason), done->repair};
}

constexpr std::array kMethods{calls::MarkerMethod{
    "motion.compact",
    calls::MethodKind::kMove,
    &calls::read_motion<decode_motion_compact, run>,
    {"The marker made shorter, all pieces moving at once.", calls::kEffortParams, calls::kRoundsResults}}};

}  // namespace

Result<MotionCompact> decode_motion_compact(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MotionCompact compact;
  compact.call = calls::read_call(fields, mistake);
  compact.effort = calls::read_effort(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return compact;
}

std::span<const calls::MarkerMethod> compaction_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::motions
