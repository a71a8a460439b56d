// Compaction of all pieces, and the critical path.
#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/compaction/critical_path.h"
#include "tests/motions/answer.h"
#include "tests/motions/arguments.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

Result<Answer> compaction(const Marker& start, const Occasion& on) {
  return answer(compact(start, random_settings(on.random), on.run));
}

// Reads the critical path and moves nothing.
Result<Answer> critical_path(const Marker& start, const Occasion& on) {
  const auto hold = motion::compaction::critical_path(start, {on.run.sums, on.run.stop});
  if (!hold) return hold.error();
  Answer answer{.marker = start, .leave = {.longest = length_of(start)}};
  for (const motion::compaction::LoadedContact& contact : hold->contacts) {
    if (!(contact.worth > 0)) answer.contradiction = "reports a contact without value";
  }
  if (!check(start, on.run.sums).valid()) answer.contradiction = "reports a critical path for an invalid marker";
  return answer;
}

template <model::Extent kExtent>
void compact_once(const Marker& marker, const scene::Run& run) {
  require(compact(marker, one_round(kExtent), run));
}

void critical_path_once(const Marker& marker, const scene::Run& run) {
  require(motion::compaction::critical_path(marker, run));
}

}  // namespace

MotionCase compact_case() {
  return {"compact",
          12,
          true,
          compaction,
          {{"compact", kAnySize, compact_once<model::Extent::kActiveSet>},
           {"compact, whole", 440, compact_once<model::Extent::kWhole>}}};
}
MotionCase critical_path_case() {
  return {"critical path", 2, false, critical_path, {{"critical path", kAnySize, critical_path_once}}};
}

}  // namespace selvage::test
