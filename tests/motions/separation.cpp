// Motions that move pieces apart: separation, the repair that it has in common with all motions, and floating.
#include <array>
#include <cmath>

#include "core/marker/validity.h"
#include "core/motion/floating/float_apart.h"
#include "core/motion/piece/bump.h"
#include "core/motion/repair/repair.h"
#include "core/motion/separation/separate.h"
#include "tests/motions/answer.h"
#include "tests/motions/arguments.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

Result<Answer> separation(const Marker& start, const Occasion& on) {
  Marker overlapping = start;
  const auto most = static_cast<Coord>(0.1 * on.random.part() * static_cast<double>(start.strip.width));
  for (Piece& piece : overlapping.pieces) {
    if (!piece.locked.x) piece.at.x += on.random.between(-most, most);
    if (!piece.locked.y) piece.at.y += on.random.between(-most, most);
  }
  // Groups are not changed.
  for (std::size_t k = 0; k < start.pieces.size(); ++k) {
    if (!start.pieces[k].group.empty()) overlapping.pieces[k].at = start.pieces[k].at;
  }
  motion::separation::SeparationSettings settings;
  settings.grow = on.random.chance(50) ? 0.1 * on.random.part() : 0;
  settings.target =
      on.random.chance(20) ? motion::repair::TargetRule::kKernelRay : motion::repair::TargetRule::kNearest;
  auto done = separate(overlapping, settings, on.run);
  // A locked piece that was moved out of the strip cannot be put back.
  if (!done && done.error().code == ErrorCode::kOutsideStrip && !is_valid(overlapping)) return unmoved(start);
  if (!done) return done.error();
  const auto longest = std::ceil((1 + settings.grow) * static_cast<double>(done->length_before));
  Answer answer{.marker = std::move(done->marker), .leave = {.longest = static_cast<Coord>(longest)}};
  answer.apart = done->apart;
  // Pieces that do not overlap may still violate a rule of the cloth; the judge checks that.
  if (done->apart && !done->remaining.empty()) answer.contradiction = "reports success although overlaps remain";
  if (done->length_after != length_of(answer.marker)) answer.contradiction = "reports a wrong length";
  answer.started = std::move(overlapping);
  return answer;
}

// Makes the middle piece overlap its neighbour by a hundredth of the strip's width, then separates.
void separate_once(const Marker& marker, const scene::Run& run) {
  Marker overlapping = marker;
  overlapping.pieces[middle_of(marker).value].at = right_of_middle(marker, 0.01);
  motion::separation::SeparationSettings settings;
  settings.rounds = 1;
  settings.grow = 0.02;
  require(separate(overlapping, settings, run));
}

// Bumps the middle piece to the right, then makes it overlap the piece that it met by half of the largest overlap that
// is repaired.
void repair_once(const Marker& marker, const scene::Run& run) {
  Marker overlapping = marker;
  Vec& at = overlapping.pieces[middle_of(marker).value].at;
  SumCache others;
  at = motion::piece::bump(scene::Scene{marker, others}, middle_of(marker), 1, 0).at;
  at = right_of_middle(overlapping, motion::repair::kRepairLimit / 2);
  scene::Scene scene{overlapping, run.sums};
  require(motion::repair::repair_overlaps(scene, run));
}

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

MotionCase separate_case() {
  return {"separate",
          10,
          false,
          separation,
          {{"repair one", kAnySize, repair_once}, {"separate one", kAnySize, separate_once}}};
}

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
