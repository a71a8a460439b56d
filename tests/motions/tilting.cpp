// Compaction with tilts.
#include "core/motion/tilting/tilt.h"
#include "tests/motions/answer.h"
#include "tests/motions/arguments.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

Result<Answer> tilting(const Marker& start, const Occasion& on) {
  const motion::tilting::TiltMethod method =
      on.random.chance(50) ? motion::tilting::TiltMethod::kLinearisation : motion::tilting::TiltMethod::kRelaxation;
  motion::tilting::TiltSettings settings = tilt_settings(method, motion::compaction::Accuracy::kDraft);
  settings.rounds = static_cast<int>(on.random.between(1, 4));
  settings.perturbations = on.random.chance(20) ? 1 : 0;
  if (on.random.chance(50)) settings.limit = any_limit(on.random);
  auto done = tilt(start, settings, on.run);
  return answer(std::move(done), {.tilts = true, .tilt_limit = settings.limit});
}

void tilt_once(const Marker& marker, const scene::Run& run) {
  motion::tilting::TiltSettings settings =
      tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard);
  settings.rounds = 1;
  settings.compaction = one_round(model::Extent::kActiveSet);
  require(tilt(marker, settings, run));
}

}  // namespace

MotionCase tilt_case() {
  return {"tilt", 3, true, tilting, {{"tilt", kAnySize, tilt_once}}};
}

}  // namespace selvage::test
