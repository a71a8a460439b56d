// The baselines: one piece at a time, and velocities.
#include "core/motion/baseline/one_at_a_time.h"
#include "core/motion/baseline/velocity.h"
#include "tests/motions/answer.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

constexpr int kFewSteps = 60;  // step limit of the velocity model, which would need many

Result<Answer> sweeps(const Marker& start, const Occasion& on) {
  const motion::baseline::SweepSettings settings{.sweeps = static_cast<int>(on.random.between(1, 20))};
  return answer(motion::baseline::compact_one_at_a_time(start, settings, on.run));
}

Result<Answer> velocities(const Marker& start, const Occasion& on) {
  motion::baseline::VelocitySettings settings;
  settings.steps = kFewSteps;
  return answer(compact_by_velocities(start, settings, on.run));
}

void sweep_once(const Marker& marker, const scene::Run& run) {
  motion::baseline::SweepSettings settings;
  settings.sweeps = 1;
  require(motion::baseline::compact_one_at_a_time(marker, settings, run));
}

void step_once(const Marker& marker, const scene::Run& run) {
  motion::baseline::VelocitySettings settings;
  settings.steps = 1;
  require(compact_by_velocities(marker, settings, run));
}

}  // namespace

MotionCase one_at_a_time_case() {
  return {"compact one at a time", 4, true, sweeps, {{"one at a time", kAnySize, sweep_once}}};
}
MotionCase velocities_case() {
  return {"compact by velocities", 1, true, velocities, {{"velocities", kAnySize, step_once}}};
}

}  // namespace selvage::test
