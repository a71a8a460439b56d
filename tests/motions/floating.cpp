// Floating pieces apart.
#include <array>

#include "core/motion/floating/float_apart.h"
#include "tests/motions/answer.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

Result<Answer> floating(const Marker& start, const Occasion& on) {
  constexpr std::array kModes{motion::floating::FloatMode::kLargestMinimum, motion::floating::FloatMode::kGivenDistance,
                              motion::floating::FloatMode::kLargestTotal, motion::floating::FloatMode::kUniform,
                              motion::floating::FloatMode::kTwoStep};
  const auto distance = start.strip.width / on.random.between(5, 400) + 1;
  motion::floating::FloatSettings settings = float_settings(kModes[on.random.below(kModes.size())], distance);
  settings.edges = on.random.chance(50);
  auto done = float_apart(start, settings, on.run);
  const bool narrower = done && done->least_after < done->least_before;
  auto result = answer(std::move(done));
  if (result && narrower) result->contradiction = "reduced the smallest gap";
  return result;
}

template <motion::floating::FloatMode kMode>
void float_once(const Marker& marker, const scene::Run& run) {
  motion::floating::FloatSettings settings = float_settings(kMode, marker.strip.width / 500);
  settings.rounds = 1;
  require(float_apart(marker, settings, run));
}

}  // namespace

MotionCase float_case() {
  return {"float",
          4,
          true,
          floating,
          {{"float, given distance", kAnySize, float_once<motion::floating::FloatMode::kGivenDistance>},
           {"float, largest minimum", kAnySize, float_once<motion::floating::FloatMode::kLargestMinimum>},
           {"float, largest total", kAnySize, float_once<motion::floating::FloatMode::kLargestTotal>},
           {"float, two steps", kAnySize, float_once<motion::floating::FloatMode::kTwoStep>},
           {"float, uniform", kAnySize, float_once<motion::floating::FloatMode::kUniform>}}};
}

}  // namespace selvage::test
