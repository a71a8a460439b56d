// Searches that use motions: refinement, and swaps of pieces.
#include "core/search/refine.h"
#include "core/search/swap.h"
#include "tests/motions/answer.h"
#include "tests/motions/arguments.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

constexpr std::uint64_t kLittleEffort = 60;

Result<Answer> refinement(const Marker& start, const Occasion& on) {
  const search::RefineSettings settings{.variants = static_cast<int>(on.random.chance(30) ? on.random.below(5) : 0),
                                        .effort = kLittleEffort,
                                        .tilts = on.random.chance(50),
                                        .seed = static_cast<std::uint32_t>(on.random.below(1000))};
  return answer(refine(start, settings, on.run), {.tilts = true, .turns = true});
}

Result<Answer> swapping(const Marker& start, const Occasion& on) {
  std::mt19937 random{static_cast<std::uint32_t>(on.random.below(1000))};
  const auto drawn = search::draw_swap(start, random);
  const motion::compaction::CompactionSettings settings = random_settings(on.random);
  auto done = drawn ? complete_swap(*drawn, settings, {on.run.sums, on.run.stop}) : search::SwapOutcome{};
  const Leave leave{.longest = kAnyLength, .turns = true};
  return Answer{.marker = done.marker ? std::move(*done.marker) : start, .leave = leave};
}

}  // namespace

MotionCase refine_case() {
  return {"refine", 1, true, refinement};
}
MotionCase swap_case() {
  return {"swap", 4, false, swapping};
}

}  // namespace selvage::test
