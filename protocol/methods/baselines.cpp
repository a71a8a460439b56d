// motion.oneAtATime and motion.velocity: what compaction is measured against.
#include <array>

#include "core/motion/one_at_a_time.h"
#include "core/motion/velocity.h"
#include "protocol/methods/families.h"
#include "protocol/methods/motion.h"

namespace selvage {
namespace {

// Either takes {"rounds"?}
struct Baseline {
  MotionCall call;
  std::optional<int> rounds;
};

Result<Baseline> decode(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  Baseline wanted;
  wanted.call = read_call(fields, mistake);
  wanted.rounds = read_rounds(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

Result<Motion> motion_of(Result<Compaction> done) {
  if (!done) return done.error();
  return Motion{std::move(done->marker), rounds_json(done->rounds, done->reason), done->healing};
}

Result<Motion> run_one_at_a_time(const Baseline& wanted, const Marker& start, const Means& means) {
  SweepSettings settings;
  settings.sweeps = wanted.rounds.value_or(settings.sweeps);
  return motion_of(compact_one_at_a_time(start, settings, means.sums, means.stop, means.observer));
}

Result<Motion> run_velocity(const Baseline& wanted, const Marker& start, const Means& means) {
  VelocitySettings settings;
  settings.steps = wanted.rounds.value_or(settings.steps);
  return motion_of(compact_by_velocities(start, settings, means.sums, means.stop, means.observer));
}

constexpr std::array kMethods{
    MarkerMethod{"motion.oneAtATime",
                 MethodKind::kMove,
                 &read_motion<decode, run_one_at_a_time>,
                 {"A baseline: every piece bumped to the left, one after another.", kRoundsParams, kRoundsResults}},
    MarkerMethod{"motion.velocity",
                 MethodKind::kMove,
                 &read_motion<decode, run_velocity>,
                 {"A baseline: pieces pushed by a piston, time step by time step.", kRoundsParams, kRoundsResults}}};

}  // namespace

std::span<const MarkerMethod> baseline_methods() {
  return kMethods;
}

}  // namespace selvage
