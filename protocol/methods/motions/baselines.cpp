// motion.oneAtATime and motion.velocity: what compaction is measured against.
#include <array>

#include "core/motion/baseline/one_at_a_time.h"
#include "core/motion/baseline/velocity.h"
#include "protocol/calls/motion.h"
#include "protocol/methods/motions/families.h"

namespace selvage::protocol::methods::motions {
namespace {

// Either takes {"rounds"?}
struct Baseline {
  calls::MotionCall call;
  std::optional<int> rounds;
};

Result<Baseline> decode(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  Baseline wanted;
  wanted.call = calls::read_call(fields, mistake);
  wanted.rounds = calls::read_rounds(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

Result<calls::Motion> motion_of(Result<motion::compaction::Compaction> done) {
  if (!done) return done.error();
  return calls::Motion{std::move(done->marker), calls::rounds_json(done->rounds, done->reason), done->repair};
}

Result<calls::Motion> run_one_at_a_time(const Baseline& wanted, const Marker& start,
                                        const calls::MethodContext& context) {
  motion::baseline::SweepSettings settings;
  settings.sweeps = wanted.rounds.value_or(settings.sweeps);
  return motion_of(compact_one_at_a_time(start, settings, context.run));
}

Result<calls::Motion> run_velocity(const Baseline& wanted, const Marker& start, const calls::MethodContext& context) {
  motion::baseline::VelocitySettings settings;
  settings.steps = wanted.rounds.value_or(settings.steps);
  return motion_of(compact_by_velocities(start, settings, context.run));
}

constexpr std::array kMethods{calls::MarkerMethod{"motion.oneAtATime",
                                                  calls::MethodKind::kMove,
                                                  &calls::read_motion<decode, run_one_at_a_time>,
                                                  {"A baseline: every piece bumped to the left, one after another.",
                                                   calls::kRoundsParams, calls::kRoundsResults}},
                              calls::MarkerMethod{"motion.velocity",
                                                  calls::MethodKind::kMove,
                                                  &calls::read_motion<decode, run_velocity>,
                                                  {"A baseline: pieces pushed by a piston, time step by time step.",
                                                   calls::kRoundsParams, calls::kRoundsResults}}};

}  // namespace

std::span<const calls::MarkerMethod> baseline_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::motions
